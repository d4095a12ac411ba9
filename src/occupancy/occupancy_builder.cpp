// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_builder.h"

#include <algorithm>
#include <utility>

namespace revisit_slam {
namespace {

constexpr double kTurn = 0.35;  // rad

/// `count` where the larger of two counts, `largest`, becomes kMostCount; never 0 unless it was.
int scaled(int count, int largest) {
  const int rounded = (2 * count * BlockCounts::kMostCount + largest) / (2 * largest);
  return count == 0 ? 0 : std::max(1, rounded);
}

VoxelMask above(const BlockCounter& counter, int plane) {
  VoxelMask mask;
  for (; plane < BlockCounter::kPlanes; ++plane) mask = mask | counter.planes[plane];
  return mask;
}

BlockCounts compact(const BlockCounter& hits, const BlockCounter& misses, const VoxelMask& driven) {
  const VoxelMask large = above(hits, 2) | above(misses, 2);
  BlockCounts counts{{hits.planes[0] & ~large, hits.planes[1] & ~large, misses.planes[0] & ~large,
                      misses.planes[1] & ~large, driven}};
  large.forEach([&](int bit) {
    const int h = hits.at(bit), m = misses.at(bit);
    const int largest = std::max(h, m);
    counts.set(bit, scaled(h, largest), scaled(m, largest));
  });
  return counts;
}

}  // namespace

void BlockCounter::add(const VoxelMask& mask) {
  VoxelMask carry = mask;
  for (VoxelMask& plane : planes) {
    const VoxelMask next = plane & carry;
    plane = plane ^ carry;
    carry = next;
  }
  for (VoxelMask& plane : planes) plane = plane | carry;
}

int BlockCounter::at(int bit) const {
  int count = 0;
  for (int plane = 0; plane < kPlanes; ++plane) count |= planes[plane].test(bit) << plane;
  return count;
}

bool OccupancyBuilder::insert(const Points& points_base, const Pose& T_submap_base,
                              const Eigen::Vector3d& sensor_base,
                              const std::vector<PointsView>& views) {
  if (!moved(T_submap_base)) return false;
  T_submap_last_ = T_submap_base;
  const std::vector<PointsView> all{{sensor_base, points_base.size()}};
  for (const ScanRaysBlock& seen :
       rays_.cast(points_base, T_submap_base, views.empty() ? all : views)) {
    Block& block = table_.at(seen.block);
    block.hits.add(seen.hit);
    block.misses.add(seen.miss);
  }
  return true;
}

void OccupancyBuilder::drive(const Pose& T_submap_from, const Pose& T_submap_to,
                             const Eigen::Vector3d& sensor_base) {
  const double step = 0.5 * config_.resolution;
  const double way = (T_submap_to.translation - T_submap_from.translation).norm();
  const double height = std::max(0.0, sensor_base.norm() - config_.resolution);
  const int steps_on = static_cast<int>(way / step), steps_down = static_cast<int>(height / step);
  for (int i = 0; i <= steps_on; ++i) {
    const double share = static_cast<double>(i) / (steps_on + 1);
    const Eigen::Vector3d back = share * (T_submap_from.translation - T_submap_to.translation);
    for (int k = 0; k <= steps_down; ++k) {
      const double down = k * step / std::max(sensor_base.norm(), step);
      markDriven(T_submap_to * Eigen::Vector3d((1.0 - down) * sensor_base) + back);
    }
  }
}

/// With the voxels beside it of which some point is so near that a map that is turned may have it
/// in the voxel of the way.
void OccupancyBuilder::markDriven(const Eigen::Vector3d& p_submap) {
  constexpr double half_diagonal = 0.71;
  const Eigen::Vector3d p = p_submap / config_.resolution;
  const Voxel home = voxelOf<double>(p);
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y) {
      const Voxel voxel = home + Voxel(x, y, 0);
      const Eigen::Array2d from_centre = (voxel.cast<double>() - p).head<2>().array() + 0.5;
      if ((from_centre.abs() - 0.5).max(0.0).matrix().norm() <= half_diagonal)
        table_.at(blockOf(voxel)).driven.set(bitOf(voxel));
    }
}

SubmapOccupancyPtr OccupancyBuilder::close() {
  std::vector<Block> blocks = std::move(std::exchange(table_, {}).blocks());
  std::sort(blocks.begin(), blocks.end(),
            [](const Block& a, const Block& b) { return BlockOrder()(a.block, b.block); });
  auto occupancy = std::make_shared<SubmapOccupancy>(config_.resolution);
  for (const Block& block : blocks)
    occupancy->append(block.block, compact(block.hits, block.misses, block.driven));
  occupancy->shrinkToFit();
  T_submap_last_.reset();
  return occupancy;
}

bool OccupancyBuilder::moved(const Pose& T_submap_base) const {
  if (!T_submap_last_) return true;
  const Pose T_last_base = T_submap_last_->inverse() * T_submap_base;
  return T_last_base.translation.norm() >= config_.scan_spacing || T_last_base.angle() >= kTurn;
}

}  // namespace revisit_slam
