// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/projected_grid.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "revisit_slam/occupancy/ground_heights.h"

namespace revisit_slam {
namespace {

/// Heights of voxels, the first and the one behind the last.
struct Band {
  int begin, end;

  Band above(int ground) const { return {ground + 1 + begin, ground + 1 + end}; }

  /// The bits of a block's column within the band.
  unsigned bits(int block_z) const {
    const int low = std::clamp(begin - kBlockEdge * block_z, 0, kBlockEdge);
    const int high = std::clamp(end - kBlockEdge * block_z, low, kBlockEdge);
    return ((1u << high) - 1u) & ~((1u << low) - 1u);
  }
};

/// The robot was above the ground of the column, and has gone under whatever is higher there.
bool wasDriven(const BlockStack& stack, int c, const Band& robot) {
  return std::any_of(stack.begin, stack.end, [&](const OccupancyBlock& block) {
    return (BlockStack::column(block.driven, c) & robot.bits(block.block.z())) != 0;
  });
}

std::int8_t stateOf(const BlockStack& stack, int c, const Band& band) {
  std::int8_t state = ProjectedGrid::kUnknown;
  for (auto block = stack.begin; block != stack.end; ++block) {
    const unsigned bits = band.bits(block->block.z());
    if (BlockStack::column(block->occupied, c) & bits) return ProjectedGrid::kOccupied;
    if (BlockStack::column(block->free, c) & bits) state = ProjectedGrid::kFree;
  }
  return state;
}

}  // namespace

ProjectedGrid projectedGrid(const OccupancyVoxels& map, const ProjectedGridConfig& config,
                            double most_cells) {
  const std::vector<BlockStack> stacks = stacksOf(map.blocks);
  if (stacks.empty()) return {};
  Eigen::Vector2i first = stacks.front().place, last = first;
  for (const BlockStack& stack : stacks) {
    first = first.cwiseMin(stack.place);
    last = last.cwiseMax(stack.place);
  }
  const Eigen::Array2d blocks = (last.cast<double>() - first.cast<double>()).array() + 1.0;
  const double cells = (kBlockEdge * blocks).prod();
  if (cells > most_cells) {
    std::ostringstream text;
    text << "the grid would have " << cells << " cells, " << most_cells << " are allowed";
    throw std::length_error(text.str());
  }
  ProjectedGrid grid;
  grid.resolution = map.resolution;
  grid.origin = grid.resolution * kBlockEdge * first.cast<double>();
  grid.width = kBlockEdge * (last.x() - first.x() + 1);
  grid.height = kBlockEdge * (last.y() - first.y() + 1);
  grid.cells.assign(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height),
                    ProjectedGrid::kUnknown);

  const auto voxels = [&](double height) {
    return static_cast<int>(std::lround(height / grid.resolution));
  };
  const Band band{voxels(config.lowest),
                  std::max(voxels(config.highest), voxels(config.lowest) + 1)};
  const Band robot{0, band.end};
  const GroundHeights ground(stacks);
  for (const BlockStack& stack : stacks) {
    if (!ground.known(stack)) continue;
    for (int c = 0; c < BlockStack::kColumns; ++c) {
      const Eigen::Vector2i cell = kBlockEdge * (stack.place - first) + BlockStack::inBlock(c);
      grid.cells[static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(grid.width) +
                 static_cast<std::size_t>(cell.x())] =
          wasDriven(stack, c, robot.above(ground.below(stack, c)))
              ? ProjectedGrid::kFree
              : stateOf(stack, c, band.above(ground.below(stack, c)));
    }
  }
  return grid;
}

}  // namespace revisit_slam
