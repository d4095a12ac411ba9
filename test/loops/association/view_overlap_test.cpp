// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/association/view_overlap.h"

#include <gtest/gtest.h>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

/// A floor from x = 0 to `length`, 30 m wide, one point a metre.
CoarseView floorOf(float length) {
  Points points;
  for (float x = 0.5f; x < length; x += 1.0f)
    for (float y = 0.5f; y < 30.0f; y += 1.0f) points.emplace_back(x, y, 1.5f);
  return CoarseView(points);
}

Pose shifted(double x, double y, double z) {
  return {Eigen::Quaterniond::Identity(), {x, y, z}};
}

TEST(ViewOverlap, IsTheShareOfTheLarger) {
  EXPECT_DOUBLE_EQ(CoarseView::overlap(floorOf(30), floorOf(30), Pose::identity()), 1.0);
  EXPECT_DOUBLE_EQ(CoarseView::overlap(floorOf(15), floorOf(30), Pose::identity()), 0.5);
  EXPECT_DOUBLE_EQ(CoarseView::overlap(floorOf(30), floorOf(15), Pose::identity()), 0.5);
}

TEST(ViewOverlap, FallsWithTheDistance) {
  EXPECT_NEAR(CoarseView::overlap(floorOf(30), floorOf(30), shifted(15, 0, 0)), 0.5, 0.1);
  EXPECT_EQ(CoarseView::overlap(floorOf(30), floorOf(30), shifted(60, 0, 0)), 0.0);
  EXPECT_EQ(CoarseView::overlap(floorOf(30), floorOf(30), shifted(0, 0, 6)), 0.0);
}

TEST(ViewOverlap, ForgivesAGuessThatIsAMetreOff) {
  EXPECT_GT(CoarseView::overlap(floorOf(30), floorOf(30), shifted(1, 1, 1)), 0.85);
}

TEST(ViewOverlap, TurnsTheSource) {
  const Pose turned{expSO3({0, 0, M_PI}), {30, 30, 0}};
  EXPECT_GT(CoarseView::overlap(floorOf(30), floorOf(30), turned), 0.95);
}

TEST(ViewOverlap, NothingSharesNothing) {
  EXPECT_EQ(CoarseView::overlap(CoarseView({}), CoarseView({}), Pose::identity()), 0.0);
}

}  // namespace
}  // namespace revisit_slam
