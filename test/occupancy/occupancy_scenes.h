// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "revisit_slam/occupancy/occupancy_map.h"
#include "support/random_numbers.h"

namespace revisit_slam {

struct VoxelCounts {
  Voxel voxel;
  int hits, misses;
};

inline SubmapOccupancyPtr submapOf(const std::vector<VoxelCounts>& voxels,
                                   double resolution = 0.5) {
  std::map<Voxel, BlockCounts, BlockOrder> blocks;
  for (const VoxelCounts& v : voxels)
    blocks[blockOf(v.voxel)].set(bitOf(v.voxel), v.hits, v.misses);
  auto submap = std::make_shared<SubmapOccupancy>(resolution);
  for (const auto& [block, counts] : blocks) submap->append(block, counts);
  return submap;
}

/// A cube of voxels around the origin, each hit or passed at random.
inline SubmapOccupancyPtr randomSubmap(RandomNumbers& random, int half = 12) {
  std::vector<VoxelCounts> voxels;
  for (int x = -half; x < half; ++x)
    for (int y = -half; y < half; ++y)
      for (int z = -half; z < half; ++z) {
        const bool hit = random.uniform(0, 1) < 0.1, passed = random.uniform(0, 1) < 0.8;
        if (hit || passed) voxels.push_back({{x, y, z}, hit ? 2 : 0, passed ? 1 : 0});
      }
  return submapOf(voxels);
}

inline OccupancyVoxels mapOf(const SubmapOccupancyPtr& submap, const Pose& T_map_submap = {}) {
  OccupancyConfig config;
  config.resolution = submap->resolution();
  OccupancyMap map(config);
  map.place({0}, submap, T_map_submap);
  map.compose();
  return map.voxels();
}

inline bool same(const std::vector<OccupancyBlock>& a, const std::vector<OccupancyBlock>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const OccupancyBlock& x, const OccupancyBlock& y) {
                      return x.block == y.block && x.occupied == y.occupied && x.free == y.free &&
                             x.driven == y.driven;
                    });
}

}  // namespace revisit_slam
