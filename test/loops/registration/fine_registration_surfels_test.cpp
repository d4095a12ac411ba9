// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/registration/fine_registration_surfels.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

TEST(FineRegistrationSurfels, TheOtherSideOfASlabIsAnotherSurface) {
  const Eigen::Vector3f up(0, 0, 1), down(0, 0, -1), tilted(0, 0.5f, 0.86f), none(0, 0, 0);
  EXPECT_TRUE(compatible(up, tilted));
  EXPECT_FALSE(compatible(up, down));
  EXPECT_TRUE(compatible(none, down));
  const SurfelGrid deck({{{0, 0, 0}, up}}, 1.0);
  EXPECT_NE(deck.nearest({0, 0, 0.2f}, up, 1.0f), nullptr);
  EXPECT_EQ(deck.nearest({0, 0, -0.2f}, down, 1.0f), nullptr);
}

}  // namespace
}  // namespace revisit_slam
