// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/route_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "revisit_slam/simulation/route.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam::simulation {
namespace {

class RouteFile : public ::testing::Test {
 protected:
  void TearDown() override { std::remove(path_.c_str()); }

  const std::string path_ = ::testing::TempDir() + "route_file_test.txt";
};

/// 1 m a pose forward along the camera's z, climbing 5 cm a metre and bending to the left.
void writeKitti(const std::string& path, int count) {
  std::ofstream file(path);
  for (int i = 0; i < count; ++i) {
    file << "1 0 0 " << -0.001 * i * i << " 0 1 0 " << -0.05 * i << " 0 0 1 " << i << "\n";
  }
}

TEST_F(RouteFile, TurnsKittiAxes) {
  writeKitti(path_, 100);
  const RecordedRoute route = readRoute(path_);
  ASSERT_EQ(route.positions.size(), 100U);
  EXPECT_NEAR(route.times.back(), 9.9, 1e-9);
  EXPECT_TRUE(route.positions.back().isApprox(Eigen::Vector3d(99.0, 9.801, 4.95), 1e-9));
}

TEST_F(RouteFile, GroundAndTimesFollowTheFile) {
  writeKitti(path_, 200);
  RouteConfig config;
  config.route = path_;
  const Route route = makeRoute(config);
  const Pose T = route.poseAt(route.start().plusSeconds(10.0));
  EXPECT_NEAR(T.translation.x(), 100.0, 1.0);
  EXPECT_NEAR(T.translation.y(), 10.0, 0.5);
  EXPECT_NEAR(T.translation.z(), 5.0, 0.3);
  EXPECT_NEAR(route.terrain().height(100.0, 10.0), 5.0, 0.3);
}

TEST_F(RouteFile, ReadsTum) {
  std::ofstream(path_)
      << "# stamp tx ty tz qx qy qz qw\n100.5 1 2 3 0 0 0 1\n100.7 3 2 3 0 0 0 1\n";
  const RecordedRoute route = readRoute(path_);
  EXPECT_NEAR(route.times.back(), 0.2, 1e-9);
  EXPECT_TRUE(route.positions.back().isApprox(Eigen::Vector3d(2.0, 0.0, 0.0)));
}

TEST_F(RouteFile, NamesTheBadLine) {
  std::ofstream(path_) << "1 0 0 0 0 0 0 1\n2 0 zero 0 0 0 0 1\n";
  try {
    readRoute(path_);
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos);
  }
}

}  // namespace
}  // namespace revisit_slam::simulation
