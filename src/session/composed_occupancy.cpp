// SPDX-License-Identifier: MIT
#include "revisit_slam/session/composed_occupancy.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "revisit_slam/occupancy/occupancy_resampling.h"
#include "revisit_slam/occupancy/occupancy_sum.h"
#include "revisit_slam/types/session_offsets.h"

namespace revisit_slam {
namespace {

constexpr double kTile = 200.0;  // m

using Tile = std::pair<int, int>;

Tile tileOf(const Voxel& block, double resolution) {
  const double tiles_per_block = kBlockEdge * resolution / kTile;
  const auto along = [&](int b) { return static_cast<int>(std::floor(b * tiles_per_block)); };
  return {along(block.x()), along(block.y())};
}

}  // namespace

OccupancyVoxels composedOccupancy(const Session& session, const OccupancyConfig& config,
                                  const ReadOccupancy& read) {
  const SessionOffsets<ScanId> scans = scansOf(session.graph);
  const auto T_map_submap = [&](const SubmapClosed& submap) {
    return session.graph.T_map_scan.at(scans[submap.first_scan]);
  };
  std::map<Tile, std::vector<const SubmapClosed*>> submaps_of_tile;
  for (const SubmapClosed& submap : session.submaps) {
    const SubmapOccupancyPtr occupancy = read(submap);
    if (!occupancy) continue;
    checkResolution(submap.id, *occupancy, config);
    std::set<Tile> tiles;
    for (const Voxel& block : blocksReached(*occupancy, roundedPose(T_map_submap(submap), config)))
      tiles.insert(tileOf(block, config.resolution));
    for (const Tile& tile : tiles) submaps_of_tile[tile].push_back(&submap);
  }
  OccupancyVoxels map{config.resolution, {}};
  for (const auto& [tile, submaps] : submaps_of_tile) {
    OccupancySum sum(config);
    const auto is_within = [&, here = tile](const Voxel& block) {
      return tileOf(block, config.resolution) == here;
    };
    for (const SubmapClosed* submap : submaps)
      if (const SubmapOccupancyPtr occupancy = read(*submap))
        sum.add(submap->id, *occupancy, T_map_submap(*submap), is_within);
    const std::vector<OccupancyBlock> blocks = sum.blocks();
    map.blocks.insert(map.blocks.end(), blocks.begin(), blocks.end());
  }
  std::sort(map.blocks.begin(), map.blocks.end(),
            [](const OccupancyBlock& a, const OccupancyBlock& b) {
              return BlockOrder()(a.block, b.block);
            });
  return map;
}

}  // namespace revisit_slam
