// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/map_scale.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

TEST(MapScale, FollowsTheVoxelsOfTheOdometryUpToTheConfiguredSize) {
  const MapScale scale{true, 0.8};
  EXPECT_EQ(scale.sizeOf(0.8), 1.0);
  EXPECT_EQ(scale.sizeOf(2.0), 1.0);
  EXPECT_EQ(scale.sizeOf(0.4), 0.5);
  EXPECT_EQ(scale.scaleOf(0.4), 1.0);
  EXPECT_EQ(scale.sizeOf(0.2), 0.25);
  EXPECT_EQ(scale.scaleOf(0.2), 0.5);
  EXPECT_EQ(scale.sizeOf(0.0), 1.0);
  EXPECT_EQ((MapScale{false, 0.8}.sizeOf(0.2)), 1.0);
}

}  // namespace
}  // namespace revisit_slam
