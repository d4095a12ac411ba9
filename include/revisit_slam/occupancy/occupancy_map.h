// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "revisit_slam/occupancy/occupancy_evidence.h"

namespace revisit_slam {

/// Union of the occupancy of submaps, at the poses that the graph gives them. Only blocks touched
/// by a submap that moved are composed again, each from all submaps that reach it. The map is a
/// function of the latest poses alone, bit for bit, whatever they were before.
class OccupancyMap {
 public:
  explicit OccupancyMap(const OccupancyConfig& config)
      : config_(config), voxels_{config.resolution, {}} {}

  /// Puts a submap into the map, or where it belongs now. Takes effect with `compose`.
  /// @return whether it is new or its rounded pose another one than before.
  /// @throws std::invalid_argument for another resolution than the map's.
  bool place(SubmapId id, SubmapOccupancyPtr occupancy, const Pose& T_map_submap);
  /// Puts a submap that is in the map where it belongs now. @return whether it is in the map.
  bool move(SubmapId id, const Pose& T_map_submap);

  /// Brings the map up to date. @return the number of blocks composed.
  std::size_t compose();

  /// As of the last `compose`.
  const OccupancyVoxels& voxels() const { return voxels_; }
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
  OccupancyVoxels voxels_;
};

}  // namespace revisit_slam
