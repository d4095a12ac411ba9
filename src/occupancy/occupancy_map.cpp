// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_map.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "revisit_slam/occupancy/occupancy_resampling.h"

namespace revisit_slam {
namespace {

bool samePose(const Pose& a, const Pose& b) {
  return a.translation == b.translation && a.rotationMatrix() == b.rotationMatrix();
}

bool before(const OccupancyBlock& a, const OccupancyBlock& b) {
  return BlockOrder()(a.block, b.block);
}

void sortUnique(std::vector<Voxel>& blocks) {
  std::sort(blocks.begin(), blocks.end(), BlockOrder());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
}

}  // namespace

bool OccupancyMap::place(SubmapId id, SubmapOccupancyPtr occupancy, const Pose& T_map_submap) {
  checkResolution(id, *occupancy, config_);
  Placed now{std::move(occupancy), roundedPose(T_map_submap, config_)};
  const auto known = submaps_.find(id);
  if (known != submaps_.end()) {
    const Placed& old = known->second;
    if (old.occupancy == now.occupancy && samePose(old.T_map_submap, now.T_map_submap))
      return false;
    touch(old);
  }
  touch(now);
  submaps_[id] = std::move(now);
  return true;
}

bool OccupancyMap::move(SubmapId id, const Pose& T_map_submap) {
  const auto known = submaps_.find(id);
  if (known == submaps_.end()) return false;
  place(id, known->second.occupancy, T_map_submap);
  return true;
}

void OccupancyMap::touch(const Placed& placed) {
  const std::vector<Voxel> reached = blocksReached(*placed.occupancy, placed.T_map_submap);
  touched_.insert(touched_.end(), reached.begin(), reached.end());
}

std::size_t OccupancyMap::compose() {
  std::vector<Voxel> touched = std::exchange(touched_, {});
  sortUnique(touched);
  std::vector<std::vector<const Placed*>> reaching(touched.size());
  for (const auto& [id, placed] : submaps_) {
    auto place = touched.begin();
    for (const Voxel& block : blocksReached(*placed.occupancy, placed.T_map_submap)) {
      place = std::lower_bound(place, touched.end(), block, BlockOrder());
      if (place == touched.end()) break;
      if (*place == block) reaching[place - touched.begin()].push_back(&placed);
    }
  }
  std::vector<OccupancyBlock> all;
  const auto is_touched = [&](const OccupancyBlock& old) {
    return std::binary_search(touched.begin(), touched.end(), old.block, BlockOrder());
  };
  std::remove_copy_if(voxels_.blocks.begin(), voxels_.blocks.end(), std::back_inserter(all),
                      is_touched);
  const auto kept = static_cast<std::ptrdiff_t>(all.size());
  for (std::size_t i = 0; i < touched.size(); ++i) {
    const OccupancyBlock block = composed(touched[i], reaching[i]);
    if (block.isKnown()) all.push_back(block);
  }
  std::inplace_merge(all.begin(), all.begin() + kept, all.end(), before);
  all.shrink_to_fit();
  voxels_.blocks = std::move(all);
  return touched.size();
}

OccupancyBlock OccupancyMap::composed(const Voxel& block,
                                      const std::vector<const Placed*>& submaps) const {
  BlockEvidence evidence;
  for (const Placed* placed : submaps)
    addEvidence(*placed->occupancy, placed->T_map_submap, block, evidence);
  return decide(block, evidence, config_);
}

std::size_t OccupancyMap::bytes() const {
  return voxels_.blocks.capacity() * sizeof(OccupancyBlock) + submaps_.size() * sizeof(Placed);
}

}  // namespace revisit_slam
