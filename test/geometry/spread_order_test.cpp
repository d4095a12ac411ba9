// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/spread_order.h"

#include <gtest/gtest.h>

#include <set>

#include "revisit_slam/geometry/voxel_filter.h"

namespace revisit_slam {
namespace {

TEST(SpreadOrder, VisitsEveryIndexOnce) {
  for (std::size_t count = 1; count < 300; ++count) {
    SpreadOrder order(count);
    std::set<std::size_t> visited;
    for (std::size_t i = 0; i < count; ++i) visited.insert(order.next());
    EXPECT_EQ(visited.size(), count);
    EXPECT_LT(*visited.rbegin(), count);
  }
}

TEST(SpreadOrder, TheFirstTenAreSpreadOverAll) {
  SpreadOrder order(1000);
  std::set<std::size_t> tenths;
  for (int i = 0; i < 10; ++i) tenths.insert(order.next() / 125);
  EXPECT_GE(tenths.size(), 7u);  // of eight parts
}

/// Points swept along x: the first of each voxel lies at its lower side.
TEST(VoxelFilter, ASpreadChoiceIsNotDrawnToTheSideThatTheSweepCameFrom) {
  Points sweep;
  for (int i = 0; i < 20000; ++i) sweep.push_back({0.01f * static_cast<float>(i), 0.5f, 0.5f});
  const auto meanOffset = [](const Points& points) {
    double sum = 0.0;
    for (const Eigen::Vector3f& p : points) sum += p.x() - std::floor(p.x()) - 0.5;
    return sum / static_cast<double>(points.size());
  };
  VoxelFilter filter;
  Points first, spread;
  filter.filter(sweep, 1.0, first);
  filter.filterSpread(sweep, 1.0, spread);
  ASSERT_EQ(first.size(), 200u);
  ASSERT_EQ(spread.size(), 200u);
  EXPECT_LT(meanOffset(first), -0.45);
  EXPECT_NEAR(meanOffset(spread), 0.0, 0.2);
}

}  // namespace
}  // namespace revisit_slam
