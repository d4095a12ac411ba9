// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "revisit_slam/occupancy/occupancy_resampling.h"

namespace revisit_slam {
namespace {

double logOdds(double probability) {
  return std::log(probability / (1.0 - probability));
}

template <typename Vector>
Vector roundedTo(double step, const Vector& v) {
  return v.unaryExpr([step](double c) { return step * std::round(c / step); });
}

/// The pose in steps that move no point within max_ray of the keypose by more than pose_step
/// voxels; half of that for the translation, half for the rotation.
Pose rounded(const Pose& T, const OccupancyConfig& config) {
  const double most = config.pose_step * config.resolution;
  if (most == 0.0) return T;
  const Eigen::Vector4d q =
      roundedTo<Eigen::Vector4d>(most / (4.0 * config.max_ray), T.rotation.coeffs());
  return {Eigen::Quaterniond(q.normalized()),
          roundedTo<Eigen::Vector3d>(most / std::sqrt(3.0), T.translation)};
}

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
  if (occupancy->resolution() != config_.resolution)
    throw std::invalid_argument("submap " + std::to_string(id.value) + " has voxels of " +
                                std::to_string(occupancy->resolution()) + " m, the map of " +
                                std::to_string(config_.resolution) + " m");
  Placed now{std::move(occupancy), rounded(T_map_submap, config_)};
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
  std::remove_copy_if(blocks_.begin(), blocks_.end(), std::back_inserter(all), is_touched);
  const auto kept = static_cast<std::ptrdiff_t>(all.size());
  for (std::size_t i = 0; i < touched.size(); ++i) {
    const OccupancyBlock block = composed(touched[i], reaching[i]);
    if (block.occupied.any() || block.free.any()) all.push_back(block);
  }
  std::inplace_merge(all.begin(), all.begin() + kept, all.end(), before);
  all.shrink_to_fit();
  blocks_ = std::move(all);
  return touched.size();
}

OccupancyBlock OccupancyMap::composed(const Voxel& block,
                                      const std::vector<const Placed*>& submaps) const {
  BlockEvidence evidence;
  for (const Placed* placed : submaps)
    addEvidence(*placed->occupancy, placed->T_map_submap, block, evidence);
  const double hit = logOdds(config_.hit), miss = logOdds(config_.miss);
  const double occupied = logOdds(config_.occupied);
  OccupancyBlock result{block, {}, {}};
  for (int bit = 0; bit < kBlockVoxels; ++bit) {
    const std::uint32_t hits = evidence.hits[bit], misses = evidence.misses[bit];
    const bool driven = evidence.driven.test(bit);
    if (hits + misses == 0 && !driven) continue;
    const bool is_occupied = !driven && hits > 0 && hits * hit + misses * miss >= occupied;
    (is_occupied ? result.occupied : result.free).set(bit);
  }
  return result;
}

void OccupancyMap::markFree(const std::function<bool(const Voxel&)>& is_free) {
  for (OccupancyBlock& block : blocks_) {
    VoxelMask freed;
    block.occupied.forEach([&](int bit) {
      if (is_free(voxelAt(block.block, bit))) freed.set(bit);
    });
    block.occupied = block.occupied & ~freed;
    block.free = block.free | freed;
  }
}

std::size_t OccupancyMap::bytes() const {
  return blocks_.capacity() * sizeof(OccupancyBlock) + submaps_.size() * sizeof(Placed);
}

Points occupiedCentres(const OccupancyMap& map) {
  const auto edge = static_cast<float>(map.resolution());
  Points centres;
  for (const OccupancyBlock& block : map.blocks())
    block.occupied.forEach([&](int bit) {
      centres.push_back(edge * (voxelAt(block.block, bit).cast<float>().array() + 0.5f));
    });
  return centres;
}

}  // namespace revisit_slam
