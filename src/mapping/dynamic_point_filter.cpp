// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/dynamic_point_filter.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "revisit_slam/geometry/voxel_walk.h"

namespace revisit_slam {
namespace {

/// Of the end of a ray, voxels: what is there may be what the ray met.
constexpr float kEnd = 2.0f;
/// Between a ray and a point that it passes, voxels.
constexpr float kClose = 0.5f;
/// How much more it takes against a voxel whose neighbours were seen at other times: what stands is
/// seen now and then, and on a busy lane one car follows another.
constexpr int kAloneRays = 6;
constexpr double kAloneShare = 10.0;
/// Below a point the ground is looked for within these voxels beside it, and that deep.
constexpr int kGroundBeside = 2, kGroundDepth = 14;

/// Shares of a line's length between which it is in the box; the first above the last: nowhere.
std::pair<float, float> within(const Eigen::AlignedBox2f& box, const Eigen::Vector2f& from,
                               const Eigen::Vector2f& to) {
  float first = 0.0f, last = 1.0f;
  for (int axis = 0; axis < 2; ++axis) {
    const float way = to[axis] - from[axis];
    if (way == 0.0f) {
      if (from[axis] < box.min()[axis] || from[axis] > box.max()[axis]) return {1.0f, 0.0f};
      continue;
    }
    const float a = (box.min()[axis] - from[axis]) / way, b = (box.max()[axis] - from[axis]) / way;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return {first, last};
}

}  // namespace

DynamicPointFilter::DynamicPointFilter(const DynamicPointConfig& config, double voxel_size,
                                       const Eigen::AlignedBox2f& box_map)
    : config_(config), scale_(static_cast<float>(1.0 / voxel_size)), box_map_(box_map) {}

void DynamicPointFilter::add(const SeenPoints& seen) {
  std::size_t i = 0;
  for (const SeenPoints::Group& group : seen.groups)
    for (; i < group.end; ++i) see(seen.points_map[i], group.time, seen.last_times[i]);
}

void DynamicPointFilter::see(const Eigen::Vector3f& point_map, double first, double last) {
  if (!box_map_.contains(point_map.head<2>())) return;
  const Voxel voxel = voxelAt(point_map);
  const auto [place, is_new] =
      block_at_.try_emplace(packVoxel(blockOf(voxel)), static_cast<std::uint32_t>(blocks_.size()));
  if (is_new) blocks_.emplace_back();
  Block& block = blocks_[place->second];
  const int bit = bitOf(voxel);
  if (!block.filled.test(bit)) {
    block.filled.set(bit);
    block.cells[bit] = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back({voxel, point_map, point_map.z(), {first, last}, {first, last}});
  }
  Cell& cell = cells_[block.cells[bit]];
  cell.lowest = std::min(cell.lowest, point_map.z());
  cell.alone.take({first, last});
}

const DynamicPointFilter::Block* DynamicPointFilter::findBlock(const Voxel& block) const {
  const auto place = block_at_.find(packVoxel(block));
  return place == block_at_.end() ? nullptr : &blocks_[place->second];
}

const DynamicPointFilter::Cell* DynamicPointFilter::find(const Voxel& voxel) const {
  const Block* block = findBlock(blockOf(voxel));
  const int bit = bitOf(voxel);
  return block == nullptr || !block->filled.test(bit) ? nullptr : &cells_[block->cells[bit]];
}

/// Not of the voxels below: there is the ground, which stands.
void DynamicPointFilter::takeTimesAround() {
  all_added_ = true;
  for (Cell& cell : cells_) {
    cell.around = cell.alone;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = 0; z <= 1; ++z)
          if (const Cell* near = find(cell.voxel + Voxel(x, y, z))) cell.around.take(near->alone);
  }
}

void DynamicPointFilter::lookThrough(const SeenPoints& seen) {
  if (!all_added_) takeTimesAround();
  std::size_t i = 0;
  for (const SeenPoints::Group& group : seen.groups)
    for (; i < group.end; ++i) follow(group.sensor_map, seen.points_map[i], group.time);
}

void DynamicPointFilter::follow(const Eigen::Vector3f& sensor_map, const Eigen::Vector3f& point_map,
                                double time) {
  const Eigen::Vector3f from = scale_ * sensor_map, way = scale_ * point_map - from;
  const float length = way.norm();
  if (length <= 2.0f * kEnd) return;
  const Eigen::Vector3f direction = way / length;
  const auto [first, last] = within(box_map_, sensor_map.head<2>(), point_map.head<2>());
  const float begin = first * length, end = std::min(last * length, length - kEnd);
  if (begin >= end) return;
  const Block* block = nullptr;
  Voxel block_at = Voxel::Constant(std::numeric_limits<int>::max());
  walkVoxels(Eigen::Vector3f(from + begin * direction), Eigen::Vector3f(from + end * direction),
             [&](const Voxel& voxel) {
               if (blockOf(voxel) != block_at) {
                 block_at = blockOf(voxel);
                 block = findBlock(block_at);
               }
               const int bit = bitOf(voxel);
               if (block == nullptr || !block->filled.test(bit)) return true;
               Cell& cell = cells_[block->cells[bit]];
               const Eigen::Vector3f to_point = scale_ * cell.point_map - from;
               if (to_point.cross(direction).squaredNorm() > kClose * kClose) return true;
               cell.alone.pass(time, config_.pause);
               cell.around.pass(time, config_.pause);
               return true;
             });
}

void DynamicPointFilter::Evidence::take(const Evidence& other) {
  first_seen = std::min(first_seen, other.first_seen);
  last_seen = std::max(last_seen, other.last_seen);
}

void DynamicPointFilter::Evidence::pass(double time, double pause) {
  ++(time < first_seen - pause || time > last_seen + pause ? rays_apart : rays_during);
}

bool DynamicPointFilter::isGround(const Cell& cell) const {
  float lowest = cell.lowest;
  for (int x = -kGroundBeside; x <= kGroundBeside; ++x)
    for (int y = -kGroundBeside; y <= kGroundBeside; ++y)
      for (int z = -kGroundDepth; z <= 0; ++z)
        if (const Cell* below = find(cell.voxel + Voxel(x, y, z)))
          lowest = std::min(lowest, below->lowest);
  return cell.point_map.z() - lowest <= static_cast<float>(config_.ground);
}

bool DynamicPointFilter::isDynamic(const Eigen::Vector3f& point_map) const {
  const Cell* cell = find(voxelAt(point_map));
  if (cell == nullptr || isGround(*cell)) return false;
  const auto is_enough = [&](const Evidence& evidence, int rays, double share) {
    return evidence.rays_apart >= rays && evidence.rays_apart >= share * evidence.rays_during;
  };
  return is_enough(cell->around, config_.rays, config_.share) ||
         is_enough(cell->alone, kAloneRays * config_.rays, kAloneShare * config_.share);
}

}  // namespace revisit_slam
