// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/registration/fine_registration_information.h"

#include <algorithm>
#include <limits>

#include "revisit_slam/geometry/voxel_filter.h"

namespace revisit_slam {
namespace {

/// Room for a patch across a voxel of the estimator's map, and more.
constexpr int kPointsPerVoxel = 50;
/// Points along each side of a patch: their spacing is to be less than the samples' range.
constexpr int kPatchSide = 4;

/// The target's surfaces. Means of voxels lie on a lattice, and where two lattices have the same
/// heading the distance between their points holds the pose along a wall as well as across it. So
/// each planar voxel becomes a patch of its plane, `edge` metres wide.
Points surfaces(const Submap& submap, double edge) {
  const float step = static_cast<float>(edge) / kPatchSide;
  const float first = 0.5f * step * (1 - kPatchSide);
  Points points;
  points.reserve(submap.points.size() * kPatchSide * kPatchSide);
  for (std::size_t i = 0; i < submap.points.size(); ++i) {
    points.push_back(submap.points[i]);
    if (submap.normals[i].isZero()) continue;
    const Eigen::Vector3f u = submap.normals[i].unitOrthogonal();
    const Eigen::Vector3f v = submap.normals[i].cross(u);
    for (int a = 0; a < kPatchSide; ++a)
      for (int b = 0; b < kPatchSide; ++b)
        points.push_back(submap.points[i] + (first + step * static_cast<float>(a)) * u +
                         (first + step * static_cast<float>(b)) * v);
  }
  return points;
}

/// The points that the target reaches. Others are beyond tau for nearly all samples: they add a
/// constant, which no derivative sees, and would only use up the estimator's share of points.
Points matched(const Points& points, const LocalVoxelMap& map, const Pose& T, double tau) {
  Points kept;
  Neighbour neighbour;
  for (const Eigen::Vector3f& p : points)
    if (map.nearest(T * Eigen::Vector3d(p.cast<double>()), tau, neighbour)) kept.push_back(p);
  return kept;
}

/// Loops are few: all their points are sampled.
InformationConfig withAllPoints(InformationConfig information) {
  information.max_points = std::numeric_limits<int>::max();
  return information;
}

}  // namespace

LoopInformation::LoopInformation(const InformationConfig& information,
                                 const FineRegistrationConfig& registration)
    : config_(registration),
      enabled_(information.enabled),
      estimator_(withAllPoints(information)) {}

const LocalVoxelMap& LoopInformation::prepared(const SubmapPtr& target, double scale) const {
  if (last_ && last_->submap == target && last_->scale == scale) return last_->map;
  const FineRegistrationConfig config = config_.scaled(scale);
  LocalVoxelMap map({config.information_distance, kPointsPerVoxel}, false);
  map.insert(surfaces(*target, config.fitness_distance), Pose::identity());
  last_ = std::make_shared<const Target>(Target{target, scale, std::move(map)});
  return last_->map;
}

InformationEstimate LoopInformation::estimate(const Submap& source, const SubmapPtr& target,
                                              const Pose& T_target_source) const {
  if (!enabled_) return {};
  const double scale = std::max(source.scale, target->scale);
  const FineRegistrationConfig config = config_.scaled(scale);
  const double tau = config.information_distance;
  const LocalVoxelMap& map = prepared(target, scale);
  Points thinned;
  VoxelFilter().filter(source.points, config.information_voxel_size, thinned);
  const Points points = matched(thinned, map, T_target_source, tau);
  return estimator_.estimate(estimator_.gather(points, map, T_target_source, tau));
}

}  // namespace revisit_slam
