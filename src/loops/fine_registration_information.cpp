// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/fine_registration_information.h"

#include "revisit_slam/geometry/voxel_filter.h"

namespace revisit_slam {
namespace {

constexpr int kPointsPerVoxel = 20;

/// The points that the target reaches. Others are beyond tau for nearly all samples: they add a
/// constant, which no derivative sees, and would only use up the estimator's share of points.
Points matched(const Points& points, const LocalVoxelMap& map, const Pose& T, double tau) {
  Points kept;
  Neighbour neighbour;
  for (const Eigen::Vector3f& p : points)
    if (map.nearest(T * Eigen::Vector3d(p.cast<double>()), tau, neighbour)) kept.push_back(p);
  return kept;
}

}  // namespace

LoopInformation::LoopInformation(const InformationConfig& information,
                                 const FineRegistrationConfig& registration)
    : config_(registration), enabled_(information.enabled), estimator_(information) {}

Matrix6 LoopInformation::estimate(const Submap& source, const Submap& target,
                                  const Pose& T_target_source) const {
  if (!enabled_) return Matrix6::Identity();
  const double tau = config_.information_distance;
  LocalVoxelMap map({tau, kPointsPerVoxel});
  map.insert(target.points, Pose::identity());
  Points thinned;
  VoxelFilter().filter(source.points, config_.information_voxel_size, thinned);
  const Points points = matched(thinned, map, T_target_source, tau);
  return estimator_.estimate(estimator_.gather(points, map, T_target_source, tau)).information;
}

}  // namespace revisit_slam
