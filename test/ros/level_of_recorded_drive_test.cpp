// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "revisit_slam/odometry/odometry.h"
#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/ros/input/scan_reader.h"

namespace revisit_slam {
namespace {

/// 16 beams on an open car park, out and back: rings on trees and hedges must not tilt the pose.
TEST(LevelOfRecordedDrive, TheWayBackIsAsHighAsTheWayOut) {
  const char* data = std::getenv("REVISIT_SLAM_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "REVISIT_SLAM_TEST_DATA is not set";
  BagScans bag({std::string(data) + "/vlp16_car_park/vlp16_car_park.bag"}, "");
  ScanReader reader{ScanInputConfig{}};
  Odometry odometry{OdometryConfig{}};
  std::vector<Eigen::Vector3d> way;
  for (const rosbag::MessageInstance& instance : bag.messages()) {
    const ScanReading reading = reader.read(*instance.instantiate<sensor_msgs::PointCloud2>());
    ASSERT_TRUE(reading.scan);
    way.push_back(odometry.registerScan(*reading.scan).scan->T_odom_base.translation);
  }
  for (std::size_t back = 340; back < way.size(); ++back) {
    const auto squared = [&](const Eigen::Vector3d& out) {
      return (out - way[back]).head<2>().squaredNorm();
    };
    const auto out = std::min_element(way.begin() + 60, way.begin() + 140,
                                      [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                                        return squared(a) < squared(b);
                                      });
    EXPECT_LT(std::abs(way[back].z() - out->z()), 0.3) << back;
  }
}

}  // namespace
}  // namespace revisit_slam
