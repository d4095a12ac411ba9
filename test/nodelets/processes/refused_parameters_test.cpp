// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/child_process.h"
#include "support/contains.h"

namespace revisit_slam {
namespace {

/// A nodelet started by hand with this private parameter.
void expectRefused(const std::string& setting, const std::string& message) {
  ChildProcess nodelet({"rosrun", "nodelet", "nodelet", "standalone", "revisit_slam/Odometry",
                        "__name:=refused", "_" + setting});
  const int status = nodelet.wait(20.0);
  EXPECT_NE(status, ChildProcess::still_running);
  EXPECT_NE(status, 0);
  EXPECT_TRUE(contains(nodelet.output(), message));
  ChildProcess({"rosparam", "delete", "/refused"}).wait(20.0);
}

TEST(RefusedParameters, unknownNameEndsTheNodeletAndIsNamed) {
  expectRefused("odometry/voxel_sise:=1",
                "unknown parameter 'odometry/voxel_sise'; did you mean 'odometry/map/voxel_size'?");
}

TEST(RefusedParameters, valueOutOfRangeEndsTheNodeletAndIsNamed) {
  expectRefused("odometry/max_range:=0.5",
                "parameter 'odometry/max_range' is '0.5', but must be 1 ");
}

TEST(RefusedParameters, aModeWithoutItsMapAndAMapWithoutItsModeEndTheNodelet) {
  expectRefused("live/mode:=localise", "parameter 'live/mode' is 'localise'");
  expectRefused("live/mode:=extend", "live/mode is extend, but live/map is empty");
  expectRefused("live/map:=somewhere", "live/map is 'somewhere', but live/mode is map");
}

TEST(RefusedParameters, wordThatIsNoChoiceEndsTheNodeletAndIsNamed) {
  expectRefused("input/time_unit:=weeks", "parameter 'input/time_unit' is 'weeks'");
}

}  // namespace
}  // namespace revisit_slam
