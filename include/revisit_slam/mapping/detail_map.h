// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/geometry/grid_points.h"
#include "revisit_slam/geometry/voxel_numbers.h"
#include "revisit_slam/types/registered_scan.h"

namespace revisit_slam {

/// Points that one scan was the first to see from one place, and follow one another in a cloud.
struct PointsSeen {
  std::uint32_t scan = 0;                                 ///< number within the submap
  Eigen::Vector3f sensor_base = Eigen::Vector3f::Zero();  ///< where their rays start
  std::uint32_t end = 0;                                  ///< behind the last of them
};

/// When and from where the points of a submap's detail were seen.
struct Sightings {
  static constexpr std::uint16_t kMostScans = 65535;

  std::vector<PointsSeen> groups;
  /// For each point: scans from the first that had a point in its voxel to the last, up to
  /// kMostScans.
  std::vector<std::uint16_t> lasted;

  bool empty() const { return lasted.empty(); }
};

/// The cloud of a submap: the first point seen in each voxel.
class DetailMap {
 public:
  /// `voxel_size` in metres.
  explicit DetailMap(double voxel_size) : voxels_per_metre_(1.0 / voxel_size) {}

  /// @param views of several sensors, which points each saw; empty: all from `sensor_base`.
  /// @param intensities one for each point, or none.
  void insert(const Points& points_base, const Pose& T_submap_base,
              const Eigen::Vector3d& sensor_base, const std::vector<PointsView>& views = {},
              const std::vector<float>& intensities = {});

  const Points& points() const { return points_; }
  /// Of the points, 0 where one has none; empty where none has one.
  const std::vector<float>& intensities() const { return intensities_; }
  const Sightings& sightings() const { return sightings_; }

 private:
  /// @return whether the point is the first in its voxel.
  bool see(const Voxel& voxel, const Eigen::Vector3d& point);

  double voxels_per_metre_;
  std::uint32_t scans_ = 0;
  Points points_;
  std::vector<float> intensities_;
  Sightings sightings_;
  std::vector<std::uint32_t> first_scans_;  // of the points
  VoxelNumbers point_in_;
};

}  // namespace revisit_slam
