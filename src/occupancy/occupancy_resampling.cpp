// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_resampling.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam {
namespace {

constexpr int kFraction = 16;  // bits behind the point
constexpr int kReach = 3;      // a turned block touches at most 3 blocks along an axis

/// From the voxels of one block of the map to the blocks of a submap that it touches, in integers,
/// so that both directions of the resampling agree to the bit.
class BlockToSubmap {
 public:
  BlockToSubmap(const Pose& T_submap_map, double resolution, const Voxel& block) {
    const Eigen::Matrix3d R = T_submap_map.rotationMatrix();
    const Eigen::Vector3d centre = (kBlockEdge * block).cast<double>().array() + 0.5;
    const Eigen::Vector3d start = R * centre + T_submap_map.translation / resolution;
    const Eigen::Vector3d lowest = start + (kBlockEdge - 1.0) * R.cwiseMin(0.0).rowwise().sum();
    const double margin = 1.0;  // voxels: hits are carried by their own centres
    first_ = voxelOf<double>((lowest.array() - margin) / kBlockEdge);
    origin_ = fixed(start - (kBlockEdge * first_).cast<double>());
    for (int axis = 0; axis < 3; ++axis) step_[axis] = fixed(R.col(axis));
  }

  /// The first of the blocks of the submap, along all axes.
  const Voxel& firstBlock() const { return first_; }

  /// Voxel in which the centre of a voxel lies: this one within its block, that one from the first
  /// voxel of the first block.
  Voxel operator()(const Voxel& in_block) const {
    const Eigen::Vector3i p =
        origin_ + in_block.x() * step_[0] + in_block.y() * step_[1] + in_block.z() * step_[2];
    return {p.x() >> kFraction, p.y() >> kFraction, p.z() >> kFraction};
  }

 private:
  static Eigen::Vector3i fixed(const Eigen::Vector3d& v) {
    const auto part = [](double c) {
      return static_cast<int>(std::lround(std::ldexp(c, kFraction)));
    };
    return {part(v.x()), part(v.y()), part(v.z())};
  }

  Voxel first_;
  Eigen::Vector3i origin_;
  Eigen::Vector3i step_[3];
};

/// The blocks of a submap around one block of the map.
class Neighbourhood {
 public:
  struct Found {
    Voxel block;
    BlockCounts counts;
  };

  Neighbourhood(const SubmapOccupancy& submap, const Voxel& first) {
    place_.fill(-1);
    for (int i = 0; i < kReach * kReach; ++i) {
      const Voxel bottom = first + Voxel(i / kReach, i % kReach, 0);
      auto entry = submap.firstFrom(bottom);
      for (; entry != submap.entries().end() && isAbove(entry->block, bottom); ++entry) {
        place_[index(entry->block - first)] = static_cast<int>(found_.size());
        found_.push_back({entry->block, submap.counts(*entry)});
      }
    }
  }

  const std::vector<Found>& found() const { return found_; }

  /// The voxel from the first one of `first`; null where nothing was seen.
  const BlockCounts* countsAt(const Voxel& voxel) const {
    const int place = place_[index(blockOf(voxel))];
    return place < 0 ? nullptr : &found_[place].counts;
  }

 private:
  static bool isAbove(const Voxel& block, const Voxel& bottom) {
    return block.head<2>() == bottom.head<2>() && block.z() < bottom.z() + kReach;
  }
  static int index(const Voxel& near) { return (near.x() * kReach + near.y()) * kReach + near.z(); }

  std::array<int, kReach * kReach * kReach> place_;
  std::vector<Found> found_;
};

void takeCounts(const Neighbourhood& submap, const BlockToSubmap& to_submap,
                BlockEvidence& evidence) {
  for (int bit = 0; bit < kBlockVoxels; ++bit) {
    const Voxel source = to_submap(voxelAt(Voxel::Zero(), bit));
    const BlockCounts* counts = submap.countsAt(source);
    if (counts == nullptr) continue;
    const int source_bit = bitOf(source);
    evidence.hits[bit] += counts->hits(source_bit);
    evidence.misses[bit] += counts->misses(source_bit);
    if (counts->driven(source_bit)) evidence.driven.set(bit);
  }
}

void carryHits(const Neighbourhood& submap, const BlockToSubmap& to_submap,
               const Pose& T_map_submap, double resolution, const Voxel& block,
               BlockEvidence& evidence) {
  const Eigen::Matrix3f R = T_map_submap.rotationMatrix().cast<float>();
  for (const Neighbourhood::Found& found : submap.found()) {
    const VoxelMask hit = found.counts.hit();
    if (!hit.any()) continue;
    const Eigen::Vector3d corner = (kBlockEdge * found.block).cast<double>().array() + 0.5;
    const Eigen::Vector3f start =
        (T_map_submap.rotation * corner + T_map_submap.translation / resolution -
         (kBlockEdge * block).cast<double>())
            .cast<float>();
    hit.forEach([&](int bit) {
      const Voxel source = voxelAt(Voxel::Zero(), bit);
      const Voxel target = voxelOf<float>(start + R * source.cast<float>());
      if (blockOf(target) != Voxel::Zero()) return;
      if (to_submap(target) == kBlockEdge * (found.block - to_submap.firstBlock()) + source) return;
      evidence.hits[bitOf(target)] += found.counts.hits(bit);
    });
  }
}

}  // namespace

std::vector<Voxel> blocksReached(const SubmapOccupancy& submap, const Pose& T_map_submap) {
  const Eigen::Matrix3d R = T_map_submap.rotationMatrix();
  const Eigen::Vector3d t = T_map_submap.translation / (kBlockEdge * submap.resolution());
  const Eigen::Vector3d half = 0.5 * R.cwiseAbs().rowwise().sum();
  std::vector<Voxel> reached;
  for (const SubmapOccupancy::Entry& entry : submap.entries()) {
    const Eigen::Vector3d centre =
        R * (entry.block.cast<double>() + Eigen::Vector3d::Constant(0.5)) + t;
    const Voxel first = voxelOf<double>(centre - half), last = voxelOf<double>(centre + half);
    for (int x = first.x(); x <= last.x(); ++x)
      for (int y = first.y(); y <= last.y(); ++y)
        for (int z = first.z(); z <= last.z(); ++z) reached.emplace_back(x, y, z);
  }
  std::sort(reached.begin(), reached.end(), BlockOrder());
  reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
  return reached;
}

void addEvidence(const SubmapOccupancy& submap, const Pose& T_map_submap, const Voxel& block,
                 BlockEvidence& evidence) {
  const BlockToSubmap to_submap(T_map_submap.inverse(), submap.resolution(), block);
  const Neighbourhood near(submap, to_submap.firstBlock());
  if (near.found().empty()) return;
  takeCounts(near, to_submap, evidence);
  carryHits(near, to_submap, T_map_submap, submap.resolution(), block, evidence);
}

}  // namespace revisit_slam
