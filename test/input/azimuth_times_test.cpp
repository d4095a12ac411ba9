// SPDX-License-Identifier: MIT
#include "revisit_slam/input/azimuth_times.h"

#include <gtest/gtest.h>

#include <cmath>

namespace revisit_slam {
namespace {

constexpr double pi = 3.14159265358979;

TEST(AzimuthTimes, clockwiseFromBehindAsTheHdl64e) {
  Points points;
  for (int i = -1799; i < 1800; ++i) {
    const double angle = i * pi / 1800;
    points.emplace_back(static_cast<float>(30 * std::cos(angle)),
                        static_cast<float>(30 * std::sin(angle)), -1.f);
  }
  const std::vector<float> fractions = sweepFractions(points, {true, 180.0});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double angle = std::atan2(points[i].y(), points[i].x());
    EXPECT_NEAR(fractions[i], 0.5 * (1 - angle / pi), 1e-6);
  }
}

TEST(AzimuthTimes, counterClockwiseFromTheFront) {
  const Points points{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const std::vector<float> fractions = sweepFractions(points, {false, 0.0});
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(fractions[i], 0.25 * static_cast<double>(i), 1e-6);
}

TEST(AzimuthTimes, everyStartGivesFractionsOfOneTurn) {
  const Points points{{1, 0, 0}, {-1, 1e-9f, 0}, {-1, -1e-9f, 0}, {0, 0, 5}, {1e-30f, 1e-30f, 1}};
  for (const double start : {-360.0, -90.0, 0.0, 90.0, 360.0}) {
    for (const bool clockwise : {false, true}) {
      for (const float fraction : sweepFractions(points, {clockwise, start})) {
        EXPECT_GE(fraction, 0.f);
        EXPECT_LT(fraction, 1.f);
      }
    }
  }
}

}  // namespace
}  // namespace revisit_slam
