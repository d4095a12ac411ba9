// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/occupancy/occupancy_evidence.h"

namespace revisit_slam {

/// The blocks of the map in which the submap may say something, in BlockOrder, each once.
std::vector<Voxel> blocksReached(const SubmapOccupancy& submap, const Pose& T_map_submap);

/// Adds what the submap says about the block. A voxel of the map takes the counts of the voxel of
/// the submap in which its centre lies: so turning leaves no holes. A hit that reaches no voxel in
/// this way goes to the voxel in which its own centre lies: so turning loses no thin pole.
void addEvidence(const SubmapOccupancy& submap, const Pose& T_map_submap, const Voxel& block,
                 BlockEvidence& evidence);

}  // namespace revisit_slam
