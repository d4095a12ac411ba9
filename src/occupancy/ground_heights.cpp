// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/ground_heights.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam {
namespace {

constexpr std::size_t kFewestColumns = 8;
constexpr double kGroundShare = 0.4;
constexpr int kFarthest = 8;  // stacks that a height spreads

/// From the middle of a stack to that of a column, in stacks.
Eigen::Vector2d offsetOf(int c) {
  return (BlockStack::inBlock(c).cast<double>().array() + 0.5) / kBlockEdge - 0.5;
}

/// The value below which the share `share` of the lowest occupied voxels of the columns lies, after
/// taking out `slope`, in voxels a stack.
double quantile(const BlockStack& stack, const Eigen::Vector2d& slope, double share,
                double otherwise) {
  std::vector<double> lowest;
  for (int c = 0; c < BlockStack::kColumns; ++c)
    if (const std::optional<int> z = stack.lowestOccupied(c))
      lowest.push_back(*z - slope.dot(offsetOf(c)));
  if (lowest.size() < kFewestColumns) return otherwise;
  const auto place =
      lowest.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(lowest.size()));
  std::nth_element(lowest.begin(), place, lowest.end());
  return *place;
}

}  // namespace

GroundHeights::GroundHeights(const std::vector<BlockStack>& stacks) : stacks_(stacks) {
  for (const BlockStack& stack : stacks)
    heights_.push_back(quantile(stack, Eigen::Vector2d::Zero(), 0.5, kUnknown));
  std::vector<double> heights;
  for (const BlockStack& stack : stacks)
    heights.push_back(quantile(stack, slopeAround(stack), kGroundShare, kUnknown));
  heights_ = std::move(heights);
  for (int round = 0; round < kFarthest; ++round) spread();
}

Eigen::Vector2d GroundHeights::slopeAround(const BlockStack& stack) const {
  Eigen::Vector2d slope;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2i step = Eigen::Vector2i::Unit(axis);
    const double before = at(stack.place - step, kUnknown),
                 after = at(stack.place + step, kUnknown);
    const bool seen = before < kUnknown && after < kUnknown;
    const double most = kSteepest * kBlockEdge;
    slope[axis] = seen ? std::clamp(0.5 * (after - before), -most, most) : 0.0;
  }
  return slope;
}

int GroundHeights::below(const BlockStack& stack, int c) const {
  const double own = at(stack);
  const Eigen::Vector2d offset = offsetOf(c);
  const Eigen::Vector2i side(offset.x() < 0 ? -1 : 1, offset.y() < 0 ? -1 : 1);
  const Eigen::Vector2d w = offset.cwiseAbs();
  const double beside_x = at(stack.place + Eigen::Vector2i(side.x(), 0), own);
  const double beside_y = at(stack.place + Eigen::Vector2i(0, side.y()), own);
  const double across = at(stack.place + side, own);
  const double height = (1 - w.y()) * ((1 - w.x()) * own + w.x() * beside_x) +
                        w.y() * ((1 - w.x()) * beside_y + w.x() * across);
  return static_cast<int>(std::lround(height));
}

double GroundHeights::at(const Eigen::Vector2i& place, double otherwise) const {
  const BlockStack* stack = findStack(stacks_, place);
  return stack != nullptr && known(*stack) ? at(*stack) : otherwise;
}

double GroundHeights::lowestAround(const BlockStack& stack) const {
  double lowest = kUnknown;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      if (x != 0 || y != 0)
        lowest = std::min(lowest, at(stack.place + Eigen::Vector2i(x, y), kUnknown));
  return lowest;
}

void GroundHeights::spread() {
  std::vector<double> next;
  for (const BlockStack& stack : stacks_) {
    const double around = lowestAround(stack);
    next.push_back(known(stack) ? std::min(at(stack), around + kSteepest * kBlockEdge) : around);
  }
  heights_ = std::move(next);
}

}  // namespace revisit_slam
