// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/occupancy/block_stack.h"

namespace revisit_slam {

/// Where the ground lies below the columns of a map. A stack's ground is the height that 40 % of
/// the lowest occupied voxels of its columns stay below, after the slope between the medians of the
/// stacks beside it was taken out: so cars and walls lift it little, and a hill does not lower it.
/// A stack with few such voxels takes the lowest ground of its neighbours, and none rises from a
/// neighbour by more than kSteepest: it saw a roof or a tree alone. Between the stacks' middles the
/// ground is interpolated.
class GroundHeights {
 public:
  static constexpr double kSteepest = 0.3;  // height by distance

  /// `stacks` must outlive it.
  explicit GroundHeights(const std::vector<BlockStack>& stacks);

  bool known(const BlockStack& stack) const { return at(stack) < kUnknown; }
  /// z of the ground's voxel in column `c` of a stack whose ground is known.
  int below(const BlockStack& stack, int c) const;

 private:
  static constexpr double kUnknown = 1e9;

  double at(const BlockStack& stack) const {
    return heights_[static_cast<std::size_t>(&stack - stacks_.data())];
  }
  double at(const Eigen::Vector2i& place, double otherwise) const;
  /// Voxels a stack, in x and y.
  Eigen::Vector2d slopeAround(const BlockStack& stack) const;
  double lowestAround(const BlockStack& stack) const;
  void spread();

  const std::vector<BlockStack>& stacks_;
  std::vector<double> heights_;  // of the stacks, voxels
};

}  // namespace revisit_slam
