// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "revisit_slam/occupancy/occupancy_evidence.h"

namespace revisit_slam {

/// The occupancy of a part of the map whose submaps are not in memory together: their evidence is
/// added up. The blocks are those that OccupancyMap has, bit for bit.
class OccupancySum {
 public:
  explicit OccupancySum(const OccupancyConfig& config) : config_(config) {}

  /// Adds a submap in those blocks of the map that are wanted.
  /// @throws std::invalid_argument for another resolution than the map's.
  void add(SubmapId id, const SubmapOccupancy& occupancy, const Pose& T_map_submap,
           const std::function<bool(const Voxel& block)>& is_wanted);

  /// The blocks that are known, in BlockOrder.
  std::vector<OccupancyBlock> blocks() const;

 private:
  OccupancyConfig config_;
  std::map<Voxel, BlockEvidence, BlockOrder> evidence_;
};

}  // namespace revisit_slam
