// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "revisit_slam/occupancy/occupancy_config.h"
#include "revisit_slam/occupancy/submap_occupancy.h"
#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// One block of the map; a voxel that is neither occupied nor free is unknown.
struct OccupancyBlock {
  Voxel block;
  VoxelMask occupied;
  VoxelMask free;
};

/// Union of the occupancy of submaps, at the poses that the graph gives them. Only blocks touched
/// by a submap that moved are composed again, each from all submaps that reach it. The map is a
/// function of the latest poses alone, bit for bit, whatever they were before.
class OccupancyMap {
 public:
  explicit OccupancyMap(const OccupancyConfig& config) : config_(config) {}

  /// Puts a submap into the map, or where it belongs now. Takes effect with `compose`.
  /// @return whether it is new or its rounded pose another one than before.
  /// @throws std::invalid_argument for another resolution than the map's.
  bool place(SubmapId id, SubmapOccupancyPtr occupancy, const Pose& T_map_submap);
  /// Puts a submap that is in the map where it belongs now. @return whether it is in the map.
  bool move(SubmapId id, const Pose& T_map_submap);

  /// Brings the map up to date. @return the number of blocks composed.
  std::size_t compose();

  /// Makes occupied voxels of the composed map free where `is_free` says so, until their block is
  /// composed again.
  void markFree(const std::function<bool(const Voxel&)>& is_free);

  double resolution() const { return config_.resolution; }
  /// In BlockOrder, none empty.
  const std::vector<OccupancyBlock>& blocks() const { return blocks_; }
  /// Memory held besides the occupancy of the submaps, bytes.
  std::size_t bytes() const;

 private:
  struct Placed {
    SubmapOccupancyPtr occupancy;
    Pose T_map_submap;  // rounded
  };

  void touch(const Placed& placed);
  OccupancyBlock composed(const Voxel& block, const std::vector<const Placed*>& submaps) const;

  OccupancyConfig config_;
  std::map<SubmapId, Placed> submaps_;
  std::vector<Voxel> touched_;
  std::vector<OccupancyBlock> blocks_;
};

/// Centres of the occupied voxels, in the map frame, ordered by block.
Points occupiedCentres(const OccupancyMap& map);

}  // namespace revisit_slam
