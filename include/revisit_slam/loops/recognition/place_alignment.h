// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace revisit_slam {

/// Two points of the plane that are held to be the same, each seen in its own frame.
struct PointPair {
  Eigen::Vector2d source;
  Eigen::Vector2d target;
  double turn = 0.0;  ///< rad: angle of what is seen at the target less that at the source
};

struct PlanarAlignment {
  Eigen::Isometry2d T_target_source = Eigen::Isometry2d::Identity();
  int inliers = 0;   ///< pairs that agree and are separate from each other
  double rms = 0.0;  ///< of the inliers' distances, in the unit of the points
};

struct PlanarAlignmentConfig {
  double inlier_radius = 3.0;  ///< in the unit of the points
  double max_turn = 0.35;      ///< rad, between a pair's own turn and the alignment's
  double separation = 5.0;     ///< in the unit of the points, of inliers that count each
  int samples = 5000;
  std::uint32_t seed = 1;
};

/// The rotation and translation with which most pairs agree in place and turn: RANSAC over samples
/// of two pairs of like turn, all where there are no more than `samples`, else a seeded choice;
/// re-estimated from all that agree by least squares. Inliers side by side count as one: a street
/// corner that looks like another one has many of them, two maps of one place have them all over.
/// Without inliers where no two pairs fit together.
PlanarAlignment alignPlanar(const std::vector<PointPair>& pairs,
                            const PlanarAlignmentConfig& config);

}  // namespace revisit_slam
