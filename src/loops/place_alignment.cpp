// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/place_alignment.h"

#include <cmath>
#include <random>
#include <utility>

namespace revisit_slam {
namespace {

using Pairs = std::vector<PointPair>;

/// Least squares in the plane: the rotation is the angle of the summed products of the centred
/// points, taken as complex numbers (Horn 1987, in two dimensions).
Eigen::Isometry2d leastSquares(const Pairs& pairs) {
  Eigen::Vector2d source = Eigen::Vector2d::Zero(), target = Eigen::Vector2d::Zero();
  for (const PointPair& pair : pairs) {
    source += pair.source / static_cast<double>(pairs.size());
    target += pair.target / static_cast<double>(pairs.size());
  }
  double along = 0.0, across = 0.0;
  for (const PointPair& pair : pairs) {
    const Eigen::Vector2d s = pair.source - source, t = pair.target - target;
    along += s.dot(t);
    across += s.x() * t.y() - s.y() * t.x();
  }
  Eigen::Isometry2d T = Eigen::Isometry2d::Identity();
  T.linear() = Eigen::Rotation2Dd(std::atan2(across, along)).toRotationMatrix();
  T.translation() = target - T.linear() * source;
  return T;
}

double squaredError(const Eigen::Isometry2d& T, const PointPair& pair) {
  return (T * pair.source - pair.target).squaredNorm();
}

Pairs inliersOf(const Eigen::Isometry2d& T, const Pairs& pairs, double radius) {
  Pairs inliers;
  for (const PointPair& pair : pairs)
    if (squaredError(T, pair) < radius * radius) inliers.push_back(pair);
  return inliers;
}

/// Whether a rigid motion can bring both pairs within the radius, and says what rotation it is.
bool fitTogether(const PointPair& a, const PointPair& b, double radius) {
  const double source = (a.source - b.source).norm(), target = (a.target - b.target).norm();
  return std::min(source, target) > 2.0 * radius && std::abs(source - target) < 2.0 * radius;
}

/// Calls visit(i, j) for all i < j, or for a seeded choice of them.
template <typename Visit>
void forEachSample(std::size_t count, const PlanarAlignmentConfig& config, const Visit& visit) {
  if (count * (count - 1) / 2 <= static_cast<std::size_t>(config.samples)) {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j) visit(i, j);
    return;
  }
  std::mt19937 random(config.seed);
  for (int sample = 0; sample < config.samples; ++sample) {
    const std::size_t i = random() % count;
    visit(i, (i + 1 + random() % (count - 1)) % count);
  }
}

Pairs largestConsensus(const Pairs& pairs, const PlanarAlignmentConfig& config) {
  Pairs best;
  forEachSample(pairs.size(), config, [&](std::size_t i, std::size_t j) {
    if (!fitTogether(pairs[i], pairs[j], config.inlier_radius)) return;
    Pairs inliers = inliersOf(leastSquares({pairs[i], pairs[j]}), pairs, config.inlier_radius);
    if (inliers.size() > best.size()) best = std::move(inliers);
  });
  return best;
}

}  // namespace

PlanarAlignment alignPlanar(const Pairs& pairs, const PlanarAlignmentConfig& config) {
  if (pairs.size() < 2) return {};
  Pairs inliers = largestConsensus(pairs, config);
  if (inliers.empty()) return {};
  PlanarAlignment result;
  for (int i = 0; i < 5; ++i) {  // what agrees with the estimate from all may be more
    result.T_target_source = leastSquares(inliers);
    Pairs again = inliersOf(result.T_target_source, pairs, config.inlier_radius);
    if (again.size() <= inliers.size()) break;
    inliers = std::move(again);
  }
  double sum = 0.0;
  for (const PointPair& pair : inliers) sum += squaredError(result.T_target_source, pair);
  result.inliers = static_cast<int>(inliers.size());
  result.rms = std::sqrt(sum / static_cast<double>(inliers.size()));
  return result;
}

}  // namespace revisit_slam
