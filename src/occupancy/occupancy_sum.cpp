// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_sum.h"

#include "revisit_slam/occupancy/occupancy_resampling.h"

namespace revisit_slam {

void OccupancySum::add(SubmapId id, const SubmapOccupancy& occupancy, const Pose& T_map_submap,
                       const std::function<bool(const Voxel&)>& is_wanted) {
  checkResolution(id, occupancy, config_);
  const Pose T = roundedPose(T_map_submap, config_);
  for (const Voxel& block : blocksReached(occupancy, T))
    if (is_wanted(block)) addEvidence(occupancy, T, block, evidence_[block]);
}

std::vector<OccupancyBlock> OccupancySum::blocks() const {
  std::vector<OccupancyBlock> blocks;
  for (const auto& [block, evidence] : evidence_) {
    const OccupancyBlock decided = decide(block, evidence, config_);
    if (decided.isKnown()) blocks.push_back(decided);
  }
  return blocks;
}

}  // namespace revisit_slam
