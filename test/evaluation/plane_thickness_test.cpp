// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/plane_thickness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace revisit_slam {
namespace {

/// A wall of 3 m by 3 m across x.
Points wallAt(float x) {
  Points points;
  for (float y = 0.05f; y < 3.0f; y += 0.1f)
    for (float z = 0.05f; z < 3.0f; z += 0.1f) points.emplace_back(x, y, z);
  return points;
}

TEST(PlaneThickness, OfOneWallSeenTwiceIsZero) {
  const PlaneThickness thickness = planeThickness({wallAt(0.3f), wallAt(0.3f)}, 1.0);
  EXPECT_EQ(thickness.points, 2 * wallAt(0.3f).size());
  EXPECT_NEAR(thickness.rms(), 0.0, 1e-3);
}

TEST(PlaneThickness, OfADoubledWallIsHalfOfItsDistance) {
  for (const float apart : {0.1f, 0.2f, 0.4f})
    EXPECT_NEAR(planeThickness({wallAt(0.3f), wallAt(0.3f + apart)}, 1.0).rms(), 0.5 * apart, 1e-3);
}

TEST(PlaneThickness, CountsOnlyWhatMoreThanOneMapShows) {
  const PlaneThickness apart = planeThickness({wallAt(0.3f), wallAt(5.3f)}, 1.0);
  EXPECT_EQ(apart.points, 0u);
  EXPECT_TRUE(std::isnan(apart.rms()));
  EXPECT_EQ(planeThickness({wallAt(0.3f)}, 1.0).points, 0u);
  EXPECT_EQ(planeThickness({wallAt(0.3f), Points(4, {0.5f, 0.5f, 0.5f})}, 1.0).points, 0u);
}

TEST(PlaneThickness, AddsUpByPoints) {
  PlaneThickness sum{0.2, 10};
  sum += {0.1, 20};
  EXPECT_NEAR(sum.rms(), 0.1, 1e-12);
}

}  // namespace
}  // namespace revisit_slam
