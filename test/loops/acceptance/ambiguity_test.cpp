// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/ambiguity.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

/// Posts along x, 10 m aside, on level ground.
Submap posts(const std::vector<float>& positions) {
  Submap submap;
  for (const float x : positions)
    for (const float y : {-10.0f, 10.0f})
      for (float z = 0.0f; z < 6.0f; z += 0.5f) {
        submap.points.emplace_back(x, y, z);
        submap.normals.emplace_back(0, 0, 0);
      }
  for (float x = 0; x < 30; x += 0.5f)
    for (float y = -5; y < 5; y += 0.5f) {
      submap.points.emplace_back(x, y, -1.7f);
      submap.normals.emplace_back(0, 0, 1);
    }
  return submap;
}

const Submap kEqual = posts({0, 4, 8, 12, 16, 20, 24, 28});
const Submap kDifferent = posts({0, 3, 10, 12, 19, 24, 25, 28});

TEST(Ambiguity, PostsInARowFitOnePostFarther) {
  EXPECT_GT(rivalShare(kEqual, kEqual, Pose::identity(), 6.0), 0.8);
  EXPECT_LT(rivalShare(kDifferent, kDifferent, Pose::identity(), 6.0), 0.6);
}

TEST(Ambiguity, OnlyPosesWithinTheRadiusAreRivals) {
  EXPECT_LT(rivalShare(kEqual, kEqual, Pose::identity(), 3.0), 0.2);
  EXPECT_EQ(rivalShare(kEqual, kEqual, Pose::identity(), 0.9), 0.0);
}

TEST(Ambiguity, GroundIsNoEvidence) {
  Submap ground = posts({});
  EXPECT_EQ(rivalShare(ground, ground, Pose::identity(), 6.0), 0.0);
}

}  // namespace
}  // namespace revisit_slam
