// SPDX-License-Identifier: MIT
// MulRan and Newer College: the same sensor, one without and one with times in the file.
#include <gtest/gtest.h>

#include "datasets/dataset_writers.h"
#include "datasets/simulated_scans.h"
#include "revisit_slam/datasets/open_dataset.h"

namespace revisit_slam {
namespace {

/// As deskewable as the scan itself; the driver's order of the points is that of time, too.
TEST(Mulran, PointsAreTimedByTheirColumn) {
  const TemporaryFolder folder;
  const auto simulated = simulatedScans("spinning-64", 1024);
  writeMulran(folder, simulated);
  const auto scans = openDataset("mulran", folder.file(""));
  ASSERT_EQ(scans->size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const PointCloud cloud = scans->read(i);
    EXPECT_EQ(cloud.width, 64u * 1024);
    expectDeskewable(cloud, simulated[i]);
  }
}

TEST(Mulran, ScansOfAnotherSizeHaveNoTimes) {
  const TemporaryFolder folder;
  const SimulatedScan scan = simulatedScans("spinning-64", 100)[0];
  xyziBytes(scan.scan.points).save(folder.file("sensor_data/Ouster/1700000000500000000.bin"));
  const auto scans = openDataset("mulran", folder.file(""));
  expectWithoutTimes(scans->read(0), scan.scan.points, {1700000000500000000});
}

TEST(Mulran, GroundTruthIsMovedToTheOuster) {
  const TemporaryFolder folder;
  writeMulran(folder, simulatedScans("spinning-64", 100));
  ByteFile()
      .text("1700000000500000001,0,-1,0,100,1,0,0,200,0,0,1,30\n")
      .save(folder.file("global_pose.csv"));
  const auto truth = openDataset("mulran", folder.file(""))->groundTruth();
  ASSERT_TRUE(truth);
  ASSERT_EQ(truth->size(), 1u);
  EXPECT_EQ(truth->front().stamp.nanoseconds, 1700000000500000001);
  // The car heads along y; the sensor is before and above its origin and looks backwards.
  const Pose pose = truth->front().T_world_base;
  EXPECT_LT((pose.translation - Eigen::Vector3d(100.021, 201.7042, 31.8047)).norm(), 1e-9);
  const Eigen::Vector3d ahead = pose.rotation * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(ahead.y(), -1.0, 1e-4);
}

TEST(NewerCollege, HasTheTimesOfTheFile) {
  const TemporaryFolder folder;
  const auto simulated = simulatedScans("spinning-64", 100);
  const Paths paths = writeNewerCollege(folder, simulated);
  // Copies by hand, as the distributed folders have them, are no scans.
  std::filesystem::copy_file(paths[0], paths[0].substr(0, paths[0].size() - 4) + " (1).pcd");
  const auto scans = openDataset("newer-college", folder.file(""));
  ASSERT_EQ(scans->size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) expectDeskewable(scans->read(i), simulated[i]);
}

TEST(NewerCollege, AFileWithoutTimesIsTimedByColumn) {
  const TemporaryFolder folder;
  const SimulatedScan scan = simulatedScans("spinning-64", 1024)[0];
  ByteFile file;
  file.text(pcdHeader("x y z", "4 4 4", "F F F", 65536, "binary"));
  for (const Eigen::Vector3f& point : columnByColumn(scan)) file.putPoint(point);
  file.save(folder.file("ouster_scan/cloud_1700000000_500000000.pcd"));
  expectDeskewable(openDataset("newer-college", folder.file(""))->read(0), scan);
}

TEST(NewerCollege, GroundTruthIsMovedFromTheCamera) {
  const TemporaryFolder folder;
  writeNewerCollege(folder, simulatedScans("spinning-64", 100));
  ByteFile()
      .text("#sec,nsec,x,y,z,qx,qy,qz,qw\n1583836591,7,10,20,30,0,0,0,1\n")
      .save(folder.file("ground_truth/registered_poses.csv"));
  const auto truth = openDataset("newer-college", folder.file(""))->groundTruth();
  ASSERT_TRUE(truth);
  ASSERT_EQ(truth->size(), 1u);
  EXPECT_EQ(truth->front().stamp.nanoseconds, 1583836591000000007);
  expectPose(truth->front().T_world_base,
             {Eigen::Quaterniond(0.383, 0, 0, 0.924).normalized(), {9.916, 19.975, 30.05}});
}

}  // namespace
}  // namespace revisit_slam
