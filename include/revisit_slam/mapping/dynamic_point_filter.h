// SPDX-License-Identifier: MIT
#pragma once

#include <tsl/robin_map.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "revisit_slam/geometry/voxel.h"
#include "revisit_slam/mapping/mapping_config.h"
#include "revisit_slam/occupancy/occupancy_block.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Points of a submap in the map, with when and from where they were seen.
struct SeenPoints {
  /// Points that follow one another, seen first from one place at one time.
  struct Group {
    Eigen::Vector3f sensor_map;
    double time;      ///< s
    std::size_t end;  ///< behind the last of them
  };

  std::vector<Group> groups;
  Points points_map;
  std::vector<double> last_times;  ///< s, of each point
};

/// Finds points of what moved: rays passed close to them before the first or after the last scan
/// that saw something there, and not only in between. What stands is seen as long as rays pass by
/// it. Works on the voxels of a part of the map.
class DynamicPointFilter {
 public:
  /// @param voxel_size of the points, m. @param box_map points beyond it are left out.
  DynamicPointFilter(const DynamicPointConfig& config, double voxel_size,
                     const Eigen::AlignedBox2f& box_map);

  /// First all points are added, then the same are looked through.
  void add(const SeenPoints& seen);
  void lookThrough(const SeenPoints& seen);

  bool isDynamic(const Eigen::Vector3f& point_map) const;

 private:
  /// When something was seen, and the rays that passed close by while nothing was, and while it
  /// was.
  struct Evidence {
    double first_seen, last_seen;  // s: sessions of one map may be years apart
    int rays_apart = 0, rays_during = 0;

    void take(const Evidence& other);
    void pass(double time, double pause);
  };

  /// A voxel with points in it.
  struct Cell {
    Voxel voxel;
    Eigen::Vector3f point_map;  // the first of them
    float lowest;               // m, z of the lowest of them
    Evidence alone;             // of what was seen in it
    Evidence around;            // and in the voxels beside and above
  };

  /// Most voxels that a ray passes are empty: whole blocks of them are passed over.
  struct Block {
    VoxelMask filled;
    std::array<std::uint32_t, kBlockVoxels> cells;
  };

  Voxel voxelAt(const Eigen::Vector3f& point_map) const {
    return voxelOf<float>(scale_ * point_map);
  }
  const Block* findBlock(const Voxel& block) const;
  const Cell* find(const Voxel& voxel) const;
  void see(const Eigen::Vector3f& point_map, double first, double last);
  void takeTimesAround();
  void follow(const Eigen::Vector3f& sensor_map, const Eigen::Vector3f& point_map, double time);
  bool isGround(const Cell& cell) const;

  DynamicPointConfig config_;
  float scale_;  // voxels per metre
  Eigen::AlignedBox2f box_map_;
  bool all_added_ = false;
  std::vector<Cell> cells_;
  std::vector<Block> blocks_;
  tsl::robin_map<std::uint64_t, std::uint32_t, VoxelKeyHash> block_at_;
};

}  // namespace revisit_slam
