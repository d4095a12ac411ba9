// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/dynamic_voxels.h"

namespace revisit_slam {

void DynamicVoxels::add(const Points& kept_map, const Points& dynamic_map) {
  const auto put = [&](const Points& points, Keys& keys) {
    for (const Eigen::Vector3f& point : points)
      keys.insert(packVoxel(voxelOf<float>(scale_ * point)));
  };
  put(kept_map, kept_);
  put(dynamic_map, dynamic_);
}

bool DynamicVoxels::isBesideDynamic(const Voxel& voxel) const {
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (dynamic_.count(packVoxel(voxel + Voxel(x, y, z))) > 0) return true;
  return false;
}

void DynamicVoxels::clear(OccupancyVoxels& map) const {
  map.markFree([&](const Voxel& voxel) {
    return kept_.count(packVoxel(voxel)) == 0 && isBesideDynamic(voxel);
  });
}

}  // namespace revisit_slam
