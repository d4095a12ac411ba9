// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/revisit_cells.h"

#include <gtest/gtest.h>

#include "evaluation/evaluation_fixtures.h"

namespace revisit_slam {
namespace {

/// Appends poses 0.1 s and 1 m apart up to x = `to`, at height z.
void driveTo(Trajectory& trajectory, double to, double z = 0.0) {
  double x = trajectory.empty() ? 0.0 : trajectory.back().T_world_base.translation.x();
  const double step = to > x ? 1.0 : -1.0;
  for (; std::abs(to - x) > 0.5; x += step)
    trajectory.push_back({stampOf(trajectory.size()), {Eigen::Quaterniond::Identity(), {x, 0, z}}});
}

Trajectory outAndBack(double length, double z_back = 0.0) {
  Trajectory trajectory;
  driveTo(trajectory, length);
  driveTo(trajectory, 0.0, z_back);
  return trajectory;
}

TEST(RevisitCells, AreThosePassedAgainAfterAWhile) {
  // At 10 m/s the cell around x is left for 2 * (200 - x - 10) / 10 seconds.
  const auto revisits = findRevisits(outAndBack(200.0), {});
  ASSERT_EQ(revisits.size(), 3u);
  EXPECT_EQ(revisits[0].index, Eigen::Vector2i(0, 0));
  EXPECT_EQ(revisits[2].index, Eigen::Vector2i(2, 0));
  EXPECT_EQ(revisits[2].centre, Eigen::Vector2d(40, 0));
  for (const RevisitCell& cell : revisits) ASSERT_EQ(cell.segments.size(), 2u);
  const StampInterval there = revisits[1].segments[0].intervals.at(0);
  EXPECT_EQ(there.begin, stampOf(10));
  EXPECT_EQ(there.end, stampOf(30));
}

TEST(RevisitCells, ABorderCrossedToAndFroMakesOneSegment) {
  Trajectory trajectory;
  for (const double turn : {15.0, 5.0, 100.0}) driveTo(trajectory, turn);
  EXPECT_TRUE(findRevisits(trajectory, {}).empty());
  driveTo(trajectory, 350.0);
  driveTo(trajectory, 0.0);
  const auto revisits = findRevisits(trajectory, {});
  ASSERT_FALSE(revisits.empty());
  ASSERT_EQ(revisits[0].segments.size(), 2u);
  EXPECT_EQ(revisits[0].segments[0].intervals.size(), 2u);
}

TEST(RevisitCells, FloorsAboveOneAnotherAreNoRevisit) {
  EXPECT_EQ(findRevisits(outAndBack(200.0, 2.0), {}).size(), 3u);
  EXPECT_TRUE(findRevisits(outAndBack(200.0, 3.0), {}).empty());
}

TEST(RevisitCells, AnIntervalEndsAtAGap) {
  Trajectory trajectory = outAndBack(200.0);
  trajectory.erase(trajectory.begin() + 12, trajectory.begin() + 28);
  const auto revisits = findRevisits(trajectory, {});
  const auto& intervals = revisits.at(1).segments.at(0).intervals;
  ASSERT_EQ(intervals.size(), 2u);
  EXPECT_EQ(intervals[0].end.nanoseconds, stampOf(11).nanoseconds + 1);
  EXPECT_EQ(intervals[1].begin, stampOf(28));
}

TEST(RevisitCells, OfNothingAreNone) {
  EXPECT_TRUE(findRevisits({}, {}).empty());
}

}  // namespace
}  // namespace revisit_slam
