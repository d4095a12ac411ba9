// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/preprocessing.h"

#include <algorithm>
#include <vector>

#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

struct ChunkCount {
  std::size_t kept = 0, too_near = 0, too_far = 0, on_body = 0;
};

/// The views of the scan; one of all points where there is but one sensor.
std::vector<ScanView> viewsOf(const Scan& scan) {
  if (!scan.views.empty()) return scan.views;
  return {{scan.T_base_sensor, scan.points.size()}};
}

/// Runs of points of one view, so that each has one mounting.
std::vector<Chunk> chunksOf(const std::vector<ScanView>& views, std::vector<std::size_t>& view_of) {
  constexpr std::size_t size = 8192;
  std::vector<Chunk> chunks;
  std::size_t begin = 0;
  for (std::size_t view = 0; view < views.size(); ++view) {
    for (; begin < views[view].end; begin = chunks.back().end) {
      chunks.push_back({begin, std::min(begin + size, views[view].end)});
      view_of.push_back(view);
    }
  }
  return chunks;
}

/// Carries points one after another. Beams that fire together share their instant.
class Carrier {
 public:
  explicit Carrier(const ConstantMotion& motion) : motion_(motion), instant_(motion.at(0.0f)) {}

  Eigen::Vector3f carry(float seconds, const Eigen::Vector3f& point) {
    if (seconds != seconds_) instant_ = motion_.at(seconds);
    seconds_ = seconds;
    return motion_.carry(instant_, point);
  }

 private:
  const ConstantMotion& motion_;
  float seconds_ = 0.0f;
  ConstantMotion::Instant instant_;
};

/// The points of one chunk, written to the front of the chunk's own part of the output.
template <typename Carry>
ChunkCount preprocessChunk(const Scan& scan, const Pose& T_base_sensor, Carry carry,
                           float fraction_per_second, const OdometryConfig& config,
                           const Eigen::AlignedBox3f& body, Chunk chunk, PreprocessedScan& result) {
  const Eigen::Matrix3f R = T_base_sensor.rotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_base_sensor.translation.cast<float>();
  const auto squared = [](double range) { return static_cast<float>(range * range); };
  const float nearest = squared(config.min_range), farthest = squared(config.max_range);
  // By pointers: through the vectors the loop would load them anew for each point.
  Eigen::Vector3f* const points_base = result.points_base.data() + chunk.begin;
  float* const fractions =
      result.sweep_fractions.empty() ? nullptr : result.sweep_fractions.data() + chunk.begin;
  float* const intensities =
      result.intensities.empty() ? nullptr : result.intensities.data() + chunk.begin;
  ChunkCount count;
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Eigen::Vector3f& point = scan.points[i];
    const float range = point.squaredNorm();
    count.too_near += range < nearest;
    count.too_far += range > farthest;
    if (range < nearest || range > farthest) continue;
    const Eigen::Vector3f in_base = R * point + t;
    if (body.contains(in_base)) {
      ++count.on_body;
      continue;
    }
    points_base[count.kept] = carry(i, in_base);
    if (fractions) fractions[count.kept] = std::min(1.0f, -fraction_per_second * scan.times[i]);
    if (intensities) intensities[count.kept] = scan.intensities[i];
    ++count.kept;
  }
  return count;
}

template <typename Value>
void moveToFront(std::vector<Value>& values, std::size_t from, std::size_t count, std::size_t to) {
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(from);
  std::copy(first, first + static_cast<std::ptrdiff_t>(count),
            values.begin() + static_cast<std::ptrdiff_t>(to));
}

}  // namespace

PreprocessedScan preprocess(const Scan& scan, const ConstantMotion& motion_base,
                            const OdometryConfig& config, double seconds_since_previous,
                            const SweepMotion* sweep) {
  PreprocessedScan result;
  result.deskewed = config.deskew && !scan.times.empty();
  const bool has_fractions = result.deskewed && seconds_since_previous > 0.0;
  result.points_base.resize(scan.points.size());
  if (has_fractions) result.sweep_fractions.resize(scan.points.size());
  result.intensities.resize(scan.intensities.size());
  const auto fraction_per_second =
      static_cast<float>(has_fractions ? 1.0 / seconds_since_previous : 0.0);
  const std::vector<ScanView> views = viewsOf(scan);
  std::vector<std::size_t> view_of;
  const std::vector<Chunk> chunks = chunksOf(views, view_of);
  const Eigen::AlignedBox3f body = config.bodyBox();
  std::vector<ChunkCount> counts(chunks.size());
  Chunks(chunks.size(), 1).forEach([&](std::size_t index, Chunk) {
    const auto run = [&](auto carry) {
      return preprocessChunk(scan, views[view_of[index]].T_base_sensor, carry, fraction_per_second,
                             config, body, chunks[index], result);
    };
    if (!result.deskewed) {
      counts[index] = run([](std::size_t, const Eigen::Vector3f& point) { return point; });
    } else if (sweep != nullptr) {
      counts[index] = run([&](std::size_t i, const Eigen::Vector3f& point) {
        return sweep->carry(scan.times[i], point);
      });
    } else {
      Carrier carrier(motion_base);
      counts[index] = run([&](std::size_t i, const Eigen::Vector3f& point) {
        return carrier.carry(scan.times[i], point);
      });
    }
  });

  std::size_t kept = 0;  // close the gaps between the chunks
  for (std::size_t index = 0; index < chunks.size(); ++index) {
    const std::size_t begin = chunks[index].begin, count = counts[index].kept;
    moveToFront(result.points_base, begin, count, kept);
    if (has_fractions) moveToFront(result.sweep_fractions, begin, count, kept);
    if (!result.intensities.empty()) moveToFront(result.intensities, begin, count, kept);
    kept += counts[index].kept;
    result.too_near += counts[index].too_near;
    result.too_far += counts[index].too_far;
    result.on_body += counts[index].on_body;
    const bool ends_view = index + 1 == chunks.size() || view_of[index + 1] != view_of[index];
    if (!scan.views.empty() && ends_view)
      result.views.push_back({views[view_of[index]].T_base_sensor.translation, kept});
  }
  result.points_base.resize(kept);
  if (has_fractions) result.sweep_fractions.resize(kept);
  if (!result.intensities.empty()) result.intensities.resize(kept);
  return result;
}

}  // namespace revisit_slam
