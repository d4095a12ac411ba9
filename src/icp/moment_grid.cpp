// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/moment_grid.h"

namespace revisit_slam {

void MomentGrid::add(const Eigen::Vector3d& point) {
  const Voxel place = voxelOf<double>(point / edge_);
  if (free_.empty()) {  // before a cube has its number: where memory is short nothing has changed
    cubes_.emplace_back();
    free_.push_back(static_cast<std::uint32_t>(cubes_.size() - 1));
  }
  const std::uint32_t cube = cube_of_.tryEmplace(place, free_.back());
  if (cube == free_.back()) free_.pop_back();
  cubes_[cube].place = place;
  cubes_[cube].moments.add((point - edge_ * place.cast<double>()).cast<float>());
}

PointMoments MomentGrid::around(const Eigen::Vector3d& place) const {
  const Voxel home = voxelOf<double>(place / edge_);
  PointMoments sum;
  VoxelNumbers::Reader cube_of(cube_of_);
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const Voxel voxel = home + Voxel(x, y, z);
        const std::uint32_t cube = cube_of.at(voxel);
        if (cube == VoxelNumbers::kNone) continue;
        const Eigen::Vector3d shift = edge_ * voxel.cast<double>() - place;
        sum.add(cubes_[cube].moments, shift.cast<float>());
      }
  return sum;
}

void MomentGrid::dropBeyond(const Eigen::Vector3d& centre, double distance) {
  const Eigen::Vector3d middle = centre / edge_ - Eigen::Vector3d::Constant(0.5);
  const double limit = distance * distance / (edge_ * edge_);
  for (std::uint32_t cube = 0; cube < cubes_.size(); ++cube) {
    Cube& entry = cubes_[cube];
    if (entry.moments.count == 0.0f) continue;
    if ((entry.place.cast<double>() - middle).squaredNorm() <= limit) continue;
    free_.push_back(cube);
    entry.moments = {};
    cube_of_.erase(entry.place);
  }
}

}  // namespace revisit_slam
