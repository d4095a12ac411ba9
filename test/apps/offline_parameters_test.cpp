// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/contains.h"
#include "support/offline_program.h"

namespace revisit_slam {
namespace {

void expectRefused(const std::string& setting, const std::vector<std::string>& parts_of_message) {
  const OfflineProgram run("unread.bag", {"--set", setting});
  EXPECT_EQ(run.status, 1);
  for (const std::string& part : parts_of_message) EXPECT_TRUE(contains(run.output, part));
}

TEST(OfflineParameters, unknownNameSuggestsTheNearest) {
  expectRefused("odometry/voxel_sise=1",
                {"'odometry/voxel_sise'", "did you mean 'odometry/map/voxel_size'?"});
  expectRefused("odometry/map/voxel_sise=1", {"did you mean 'odometry/map/voxel_size'?"});
}

TEST(OfflineParameters, valueOutOfRangeNamesTheRange) {
  expectRefused("odometry/max_range=0.5", {"'odometry/max_range'", "'0.5'", "1 to 1000 m"});
}

TEST(OfflineParameters, valueOfAnotherTypeIsRefused) {
  expectRefused("odometry/deskew=maybe", {"'odometry/deskew'", "'maybe'"});
}

TEST(OfflineParameters, settingWithoutValueIsRefused) {
  expectRefused("odometry/deskew", {"key=value"});
}

TEST(OfflineParameters, oldNameIsAcceptedWithAWarning) {
  expectRefused("loops/agreement/rotation=2",  // refused for the bag alone
                {"offline: parameter 'loops/agreement/rotation' is now called "
                 "'loops/consistency/rotation'",
                 "unread.bag"});
}

TEST(OfflineParameters, fileIsNamedWhenItCannotBeRead) {
  const OfflineProgram run("unread.bag", {"--params", "/nowhere/parameters.yaml"});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.output, "/nowhere/parameters.yaml"));
}

}  // namespace
}  // namespace revisit_slam
