// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_evidence.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace revisit_slam {
namespace {

double logOdds(double probability) {
  return std::log(probability / (1.0 - probability));
}

template <typename Vector>
Vector roundedTo(double step, const Vector& v) {
  return v.unaryExpr([step](double c) { return step * std::round(c / step); });
}

}  // namespace

OccupancyBlock decide(const Voxel& block, const BlockEvidence& evidence,
                      const OccupancyConfig& config) {
  const double hit = logOdds(config.hit), miss = logOdds(config.miss);
  const double occupied = logOdds(config.occupied);
  OccupancyBlock result{block, {}, {}, evidence.driven};
  for (int bit = 0; bit < kBlockVoxels; ++bit) {
    const std::uint32_t hits = evidence.hits[bit], misses = evidence.misses[bit];
    const bool driven = evidence.driven.test(bit);
    if (hits + misses == 0 && !driven) continue;
    const bool is_occupied = !driven && hits > 0 && hits * hit + misses * miss >= occupied;
    (is_occupied ? result.occupied : result.free).set(bit);
  }
  return result;
}

Pose roundedPose(const Pose& T_map_submap, const OccupancyConfig& config) {
  const double most = config.pose_step * config.resolution;
  if (most == 0.0) return T_map_submap;
  const Eigen::Vector4d q =
      roundedTo<Eigen::Vector4d>(most / (4.0 * config.max_ray), T_map_submap.rotation.coeffs());
  return {Eigen::Quaterniond(q.normalized()),
          roundedTo<Eigen::Vector3d>(most / std::sqrt(3.0), T_map_submap.translation)};
}

void checkResolution(SubmapId id, const SubmapOccupancy& occupancy, const OccupancyConfig& config) {
  if (occupancy.resolution() == config.resolution) return;
  throw std::invalid_argument("submap " + std::to_string(id.value) + " has voxels of " +
                              std::to_string(occupancy.resolution()) + " m, the map of " +
                              std::to_string(config.resolution) + " m");
}

}  // namespace revisit_slam
