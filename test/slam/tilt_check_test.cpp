// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/tilt_check.h"

#include <gtest/gtest.h>

#include "revisit_slam/types/se3.h"
#include "support/contains.h"
#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

/// Level ground and two walls, seen by a base that is tilted against it.
RegisteredScan scanOf(const Eigen::Quaterniond& R_level_base, RandomNumbers& random) {
  RegisteredScan scan;
  scan.sensor_frame = "lidar";
  const Pose T_level_base{R_level_base, {0.0, 0.0, 1.8}};
  for (int i = 0; i < 6000; ++i) {
    Eigen::Vector3d p = random.inCube(20.0);
    p.z() = 0.02 * random.gaussian(1.0);
    if (i % 3 == 0) p = {p.x(), i % 2 == 0 ? 12.0 : -15.0, random.uniform(0.0, 6.0)};
    scan.points_base.push_back((T_level_base.inverse() * p).cast<float>());
  }
  return scan;
}

std::string told(const Eigen::Quaterniond& R_level_base) {
  RandomNumbers random(1);
  TiltCheck check;
  std::string text;
  for (int i = 0; i < 30; ++i) {
    const std::string now = check.take(scanOf(R_level_base, random));
    EXPECT_TRUE(now.empty() || text.empty()) << "told twice";
    text += now;
  }
  return text;
}

Eigen::Quaterniond tilted(double roll, double pitch) {
  return expSO3({0.0, pitch, 0.0}) * expSO3({roll, 0.0, 0.0});
}

TEST(TiltCheck, TellsTheTransformThatLevels) {
  const std::string text = told(tilted(0.0, 0.26));
  EXPECT_TRUE(contains(text, "tilted by 15 degrees")) << text;
  EXPECT_TRUE(contains(text, "'lidar'")) << text;
  EXPECT_TRUE(contains(text, "0.26 rad of pitch and")) << text;
  const std::string rolled = told(tilted(-0.2, 0.1));
  EXPECT_TRUE(contains(rolled, "0.10 rad of pitch and -0.20 rad of roll")) << rolled;
}

TEST(TiltCheck, SaysNothingOfABaseThatStandsStraight) {
  EXPECT_EQ(told(tilted(0.0, 0.0)), "");
  EXPECT_EQ(told(tilted(0.03, -0.05)), "");
}

TEST(TiltCheck, TellsOfASensorThatHangsUpsideDown) {
  const std::string text = told(tilted(M_PI, 0.0));
  EXPECT_TRUE(contains(text, "the ground seems to be above 'lidar'")) << text;
  EXPECT_TRUE(contains(text, "3.14 rad of roll more")) << text;
  EXPECT_TRUE(contains(told(tilted(M_PI + 0.1, -0.1)), "the ground seems to be above"));
}

TEST(TiltCheck, KnowsACeilingFromAGround) {
  RandomNumbers random(2);
  TiltCheck check;
  for (int i = 0; i < 20; ++i) {
    RegisteredScan scan = scanOf(tilted(0.0, 0.0), random);
    for (int k = 0; k < 9000; ++k) {  // more of it than of the floor, which is 1.8 m below
      Eigen::Vector3d p = random.inCube(20.0);
      p.z() = 1.0 + 0.02 * random.gaussian(1.0);
      scan.points_base.push_back(p.cast<float>());
    }
    EXPECT_EQ(check.take(scan), "");
  }
}

TEST(TiltCheck, SaysNothingWithoutGround) {
  TiltCheck check;
  RegisteredScan scan;
  for (int i = 0; i < 20; ++i) {
    scan.points_base.assign(3, Eigen::Vector3f(1.0f + static_cast<float>(i), 2.0f, 0.0f));
    EXPECT_EQ(check.take(scan), "");
  }
}

}  // namespace
}  // namespace revisit_slam
