// SPDX-License-Identifier: MIT
#include "revisit_slam/util/frame_name.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

TEST(FrameName, LosesTheSlashInFront) {
  EXPECT_EQ(withoutLeadingSlash("/velodyne"), "velodyne");
  EXPECT_EQ(withoutLeadingSlash("velodyne"), "velodyne");
  EXPECT_EQ(withoutLeadingSlash("/robot/base_link"), "robot/base_link");
  EXPECT_EQ(withoutLeadingSlash("robot/base_link"), "robot/base_link");
  EXPECT_EQ(withoutLeadingSlash(""), "");
}

}  // namespace
}  // namespace revisit_slam
