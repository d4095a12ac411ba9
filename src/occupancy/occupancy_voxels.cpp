// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_voxels.h"

namespace revisit_slam {

void OccupancyVoxels::markFree(const std::function<bool(const Voxel&)>& is_free) {
  for (OccupancyBlock& block : blocks) {
    VoxelMask freed;
    block.occupied.forEach([&](int bit) {
      if (is_free(voxelAt(block.block, bit))) freed.set(bit);
    });
    block.occupied = block.occupied & ~freed;
    block.free = block.free | freed;
  }
}

Points occupiedCentres(const OccupancyVoxels& map) {
  const auto edge = static_cast<float>(map.resolution);
  Points centres;
  for (const OccupancyBlock& block : map.blocks)
    block.occupied.forEach([&](int bit) {
      centres.push_back(edge * (voxelAt(block.block, bit).cast<float>().array() + 0.5f));
    });
  return centres;
}

}  // namespace revisit_slam
