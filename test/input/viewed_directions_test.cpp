// SPDX-License-Identifier: MIT
#include "revisit_slam/input/viewed_directions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace revisit_slam {
namespace {

/// Points every half degree, 64 above each other.
ViewedDirections directions(double first, double last) {
  Points points;
  for (double degree = first; degree <= last; degree += 0.5)
    for (int beam = 0; beam < 64; ++beam)
      points.emplace_back(9 * std::cos(degree * M_PI / 180), 9 * std::sin(degree * M_PI / 180),
                          0.1 * beam);
  ViewedDirections viewed;
  viewed.add(points);
  return viewed;
}

TEST(ViewedDirections, theSectorIsWhereThePointsAre) {
  for (const auto& [first, last] : {std::pair{10.0, 20.0}, {-30.0, 30.0}, {100.0, 280.0}}) {
    const ViewSector sector = directions(first, last).sector();
    EXPECT_NEAR(sector.width, last - first, 2.0);
    EXPECT_NEAR(turnBetween(sector.middle, 0.5 * (first + last)), 0.0, 2.0);
  }
}

TEST(ViewedDirections, theFullCircleIsWide) {
  EXPECT_GT(directions(0.0, 359.5).sector().width, 350.0);
  EXPECT_EQ(ViewedDirections().sector().width, 0.0);
}

TEST(ViewedDirections, theSectorsOfPartsJoin) {
  ViewedDirections viewed = directions(340.0, 355.0);
  viewed.add(directions(5.0, 20.0));
  EXPECT_NEAR(viewed.sector().width, 40.0, 2.0);
  EXPECT_NEAR(turnBetween(viewed.sector().middle, 0.0), 0.0, 2.0);
}

TEST(ViewedDirections, turnsAreTheShorterWay) {
  EXPECT_NEAR(turnBetween(350.0, 10.0), 20.0, 1e-9);
  EXPECT_NEAR(turnBetween(10.0, 350.0), -20.0, 1e-9);
  EXPECT_NEAR(turnBetween(720.0, 0.0), 0.0, 1e-9);
}

}  // namespace
}  // namespace revisit_slam
