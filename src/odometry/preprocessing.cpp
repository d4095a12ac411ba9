// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/preprocessing.h"

#include <algorithm>
#include <vector>

#include "revisit_slam/geometry/chunks.h"

namespace revisit_slam {
namespace {

struct ChunkCount {
  std::size_t kept = 0, too_near = 0, too_far = 0;
};

/// The points of one chunk, written to the front of the chunk's own part of the output.
ChunkCount preprocessChunk(const Scan& scan, const ConstantMotion* motion,
                           const OdometryConfig& config, Chunk chunk, Points& points_base) {
  const Eigen::Matrix3f R = scan.T_base_sensor.rotationMatrix().cast<float>();
  const Eigen::Vector3f t = scan.T_base_sensor.translation.cast<float>();
  const auto squared = [](double range) { return static_cast<float>(range * range); };
  const float nearest = squared(config.min_range), farthest = squared(config.max_range);
  ChunkCount count;
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Eigen::Vector3f& point = scan.points[i];
    const float range = point.squaredNorm();
    count.too_near += range < nearest;
    count.too_far += range > farthest;
    if (range < nearest || range > farthest) continue;
    const Eigen::Vector3f in_base = R * point + t;
    points_base[chunk.begin + count.kept++] =
        motion ? motion->carry(scan.times[i], in_base) : in_base;
  }
  return count;
}

}  // namespace

PreprocessedScan preprocess(const Scan& scan, const ConstantMotion& motion_base,
                            const OdometryConfig& config) {
  PreprocessedScan result;
  result.deskewed = config.deskew && !scan.times.empty();
  result.points_base.resize(scan.points.size());
  const ConstantMotion* motion = result.deskewed ? &motion_base : nullptr;
  const Chunks chunks(scan.points.size(), 8192);
  std::vector<ChunkCount> counts(chunks.size());
  chunks.forEach([&](std::size_t index, Chunk chunk) {
    counts[index] = preprocessChunk(scan, motion, config, chunk, result.points_base);
  });

  std::size_t kept = 0;  // close the gaps between the chunks
  for (std::size_t index = 0; index < chunks.size(); ++index) {
    const auto begin = result.points_base.begin() + static_cast<std::ptrdiff_t>(chunks[index].begin);
    std::copy(begin, begin + static_cast<std::ptrdiff_t>(counts[index].kept),
              result.points_base.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += counts[index].kept;
    result.too_near += counts[index].too_near;
    result.too_far += counts[index].too_far;
  }
  result.points_base.resize(kept);
  return result;
}

}  // namespace revisit_slam
