// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/place_alignment.h"

#include <algorithm>
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

bool areAlike(double angle, double other, double tolerance) {
  return std::abs(std::remainder(angle - other, 2.0 * M_PI)) <= tolerance;
}

double squaredError(const Eigen::Isometry2d& T, const PointPair& pair) {
  return (T * pair.source - pair.target).squaredNorm();
}

Pairs inliersOf(const Eigen::Isometry2d& T, const Pairs& pairs,
                const PlanarAlignmentConfig& config) {
  const double turn = Eigen::Rotation2Dd(T.linear()).angle();
  Pairs inliers;
  for (const PointPair& pair : pairs)
    if (squaredError(T, pair) < config.inlier_radius * config.inlier_radius &&
        areAlike(pair.turn, turn, config.max_turn))
      inliers.push_back(pair);
  return inliers;
}

/// Whether a rigid motion can bring both pairs within the radius, and whether they are far enough
/// from each other to tell its rotation.
bool fitTogether(const PointPair& a, const PointPair& b, const PlanarAlignmentConfig& config) {
  if (!areAlike(a.turn, b.turn, 2.0 * config.max_turn)) return false;
  const double source = (a.source - b.source).norm(), target = (a.target - b.target).norm();
  const double play = 2.0 * config.inlier_radius;
  return std::min(source, target) > play && std::abs(source - target) < play;
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
    if (!fitTogether(pairs[i], pairs[j], config)) return;
    Pairs inliers = inliersOf(leastSquares({pairs[i], pairs[j]}), pairs, config);
    if (inliers.size() > best.size()) best = std::move(inliers);
  });
  return best;
}

/// As long as more pairs agree with the estimate from all that agreed before.
Pairs grown(Pairs inliers, const Pairs& pairs, const PlanarAlignmentConfig& config) {
  for (;;) {
    Pairs again = inliersOf(leastSquares(inliers), pairs, config);
    if (again.size() <= inliers.size()) return inliers;
    inliers = std::move(again);
  }
}

/// How many can be taken, in order, so that all are as far from each other.
int countSeparate(const Pairs& pairs, double separation) {
  std::vector<Eigen::Vector2d> taken;
  for (const PointPair& pair : pairs) {
    const auto is_near = [&](const Eigen::Vector2d& other) {
      return (other - pair.source).norm() < separation;
    };
    if (std::none_of(taken.begin(), taken.end(), is_near)) taken.push_back(pair.source);
  }
  return static_cast<int>(taken.size());
}

double rmsError(const Eigen::Isometry2d& T, const Pairs& pairs) {
  double sum = 0.0;
  for (const PointPair& pair : pairs) sum += squaredError(T, pair);
  return std::sqrt(sum / static_cast<double>(pairs.size()));
}

}  // namespace

PlanarAlignment alignPlanar(const Pairs& pairs, const PlanarAlignmentConfig& config) {
  if (pairs.size() < 2) return {};
  const Pairs consensus = largestConsensus(pairs, config);
  if (consensus.empty()) return {};
  const Pairs inliers = grown(consensus, pairs, config);
  const Eigen::Isometry2d T_target_source = leastSquares(inliers);
  return {T_target_source, countSeparate(inliers, config.separation),
          rmsError(T_target_source, inliers)};
}

}  // namespace revisit_slam
