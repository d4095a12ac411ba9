// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/geometry/voxel_numbers.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// The means of the points of a grid's occupied voxels, ordered by voxel: x, then y, then z. The
/// keys are packed voxels, whose order is the same.
struct VoxelMeans {
  std::vector<std::uint64_t> keys;
  Points points;
};

/// Sums up points in cubic voxels (paper Sec. III-C: G). Sums are taken from the voxel's centre in
/// float. A voxel takes no more than kMostPoints, so that hours of standing still neither lose
/// digits nor drown what the drive sees later. What comes out depends on the order of calls alone.
class VoxelMeanGrid {
 public:
  /// `voxel_size` in metres.
  explicit VoxelMeanGrid(double voxel_size) : edge_(static_cast<float>(voxel_size)) {}

  void insert(const Points& points, const Pose& T_grid_points = {});
  std::size_t voxels() const { return cell_of_.size(); }

  /// The means, in the frame of the grid; the grid is empty afterwards and holds no memory.
  VoxelMeans take();

  static constexpr std::uint32_t kMostPoints = 1000;

 private:
  struct Cell {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();  // of offsets from the voxel's centre, m
    std::uint32_t count = 0;
  };

  Cell& cellAt(const Voxel& voxel);
  Eigen::Vector3f centre(const Voxel& voxel) const {
    return edge_ * (voxel.cast<float>() + Eigen::Vector3f::Constant(0.5f));
  }

  float edge_;
  VoxelNumbers cell_of_;
  std::vector<Cell> cells_;  // at most one more than there are voxels
};

}  // namespace revisit_slam
