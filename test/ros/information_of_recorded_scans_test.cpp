// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstdlib>

#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/ros/input/scan_reader.h"
#include "support/brute_force_objective.h"

namespace revisit_slam {
namespace {

TEST(InformationOfRecordedScans, EqualsBruteForceToTheLastBit) {
  const char* data = std::getenv("REVISIT_SLAM_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "REVISIT_SLAM_TEST_DATA is not set";
  BagScans bag({std::string(data) + "/kitti_raw_0001/kitti_raw_0001.bag"}, "");
  ScanReader reader{ScanInputConfig{}};
  BruteForceComparison comparison(8);
  Odometry odometry{OdometryConfig{}};
  int scans = 0;
  for (const rosbag::MessageInstance& instance : bag.messages()) {
    if (++scans > 12) break;
    const ScanReading reading = reader.read(*instance.instantiate<sensor_msgs::PointCloud2>());
    ASSERT_TRUE(reading.scan);
    comparison.registerScan(odometry, *reading.scan);
  }
  EXPECT_EQ(comparison.compared(), 4);
}

}  // namespace
}  // namespace revisit_slam
