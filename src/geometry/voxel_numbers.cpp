// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/voxel_numbers.h"

#include <algorithm>

namespace revisit_slam {

void VoxelNumbers::erase(const Voxel& voxel) {
  Cube& cube = cubeAt(voxel);
  cube.numbers[placeOf(voxel)] = kNone;
  --size_;
  if (--cube.used > 0) return;
  cube_of_.erase(last_key_);
  free_.push_back(last_);
  last_key_ = kNoKey;
}

std::uint32_t VoxelNumbers::findOrAdd(std::uint64_t key, const Voxel& voxel) {
  if (const auto entry = cube_of_.find(key); entry != cube_of_.end()) return entry->second;
  if (free_.empty()) {
    cubes_.emplace_back();
    free_.push_back(static_cast<std::uint32_t>(cubes_.size() - 1));
  }
  const std::uint32_t index = free_.back();
  cube_of_.emplace(key, index);
  free_.pop_back();
  Cube& cube = cubes_[index];
  cube.numbers.fill(kNone);
  cube.place = {voxel.x() >> 2, voxel.y() >> 2, voxel.z() >> 2};
  cube.used = 0;
  return index;
}

std::vector<const VoxelNumbers::Cube*> VoxelNumbers::cubesInOrder() const {
  std::vector<const Cube*> cubes;
  cubes.reserve(cubes_.size());
  for (const Cube& cube : cubes_)
    if (cube.used > 0) cubes.push_back(&cube);
  std::sort(cubes.begin(), cubes.end(),
            [](const Cube* a, const Cube* b) { return packVoxel(a->place) < packVoxel(b->place); });
  return cubes;
}

}  // namespace revisit_slam
