// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace revisit_slam {

/// Two points of the plane that are held to be the same.
struct PointPair {
  Eigen::Vector2d source;
  Eigen::Vector2d target;
};

struct PlanarAlignment {
  Eigen::Isometry2d T_target_source = Eigen::Isometry2d::Identity();
  int inliers = 0;
  double rms = 0.0;  ///< of the inliers' distances, in the unit of the points
};

struct PlanarAlignmentConfig {
  double inlier_radius = 3.0;  ///< in the unit of the points
  int samples = 1000;
  std::uint32_t seed = 1;
};

/// The rotation and translation with which most pairs agree (RANSAC over pairs of pairs: all where
/// there are no more than `samples`, else a seeded choice), re-estimated from all that agree by
/// least squares. Without inliers where no two pairs fit together.
PlanarAlignment alignPlanar(const std::vector<PointPair>& pairs,
                            const PlanarAlignmentConfig& config);

}  // namespace revisit_slam
