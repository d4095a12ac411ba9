// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "revisit_slam/occupancy/occupancy_config.h"
#include "revisit_slam/occupancy/scan_rays.h"
#include "revisit_slam/occupancy/submap_occupancy.h"
#include "revisit_slam/types/registered_scan.h"

namespace revisit_slam {

/// One number for each voxel of a block, as bit planes; stays at kMost when it gets there.
struct BlockCounter {
  static constexpr int kPlanes = 6;
  static constexpr int kMost = (1 << kPlanes) - 1;

  std::array<VoxelMask, kPlanes> planes;

  /// One more for each voxel of the mask.
  void add(const VoxelMask& mask);
  int at(int bit) const;
};

/// Counts what the scans of the open submap saw.
class OccupancyBuilder {
 public:
  explicit OccupancyBuilder(const OccupancyConfig& config)
      : config_(config), rays_(config.resolution, config.max_ray) {}

  /// Takes the scan in if the platform moved since the last one taken in.
  /// @param sensor_base where the rays start, in the base frame.
  /// @param views of several sensors, where the rays of each start; empty: all as above.
  /// @return whether it was taken in.
  bool insert(const Points& points_base, const Pose& T_submap_base,
              const Eigen::Vector3d& sensor_base, const std::vector<PointsView>& views = {});

  /// The robot has moved: between its base and its sensor, and on the way from one pose to the
  /// other, nothing is in the way, nor within 0.7 voxels beside it. The ground below the base
  /// stays.
  void drive(const Pose& T_submap_from, const Pose& T_submap_to,
             const Eigen::Vector3d& sensor_base);

  /// What was counted; the builder is empty afterwards and holds no memory of it. Of counts above
  /// BlockCounts::kMostCount the proportion of hits to misses is kept.
  SubmapOccupancyPtr close();

 private:
  struct Block {
    Voxel block;
    BlockCounter hits;
    BlockCounter misses;
    VoxelMask driven;
  };

  void markDriven(const Eigen::Vector3d& p_submap);
  bool moved(const Pose& T_submap_base) const;

  OccupancyConfig config_;
  ScanRays rays_;
  std::optional<Pose> T_submap_last_;
  OccupancyBlockTable<Block> table_;
};

}  // namespace revisit_slam
