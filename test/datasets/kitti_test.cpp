// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "datasets/dataset_writers.h"
#include "datasets/simulated_scans.h"
#include "revisit_slam/datasets/open_dataset.h"
#include "support/contains.h"

namespace revisit_slam {
namespace {

DatasetOptions asStored() {
  DatasetOptions options;
  options.correct_kitti_elevation = false;
  return options;
}

TEST(KittiOdometry, IsReadWithoutTimesOneSecondAfterItsStamps) {
  const TemporaryFolder folder;
  const auto simulated = simulatedScans("spinning-64", 100);
  writeKittiOdometry(folder, simulated);
  const auto scans = openDataset("kitti-odometry", folder.file("data/sequences/04"), asStored());
  ASSERT_EQ(scans->size(), 3u);
  const std::int64_t stamps[] = {1'000'000'000, 1'103'622'400, 1'207'209'000};
  for (std::size_t i = 0; i < 3; ++i)
    expectWithoutTimes(scans->read(i), simulated[i].scan.points, {stamps[i]});
}

TEST(KittiOdometry, ElevationIsCorrectedAndRangeAndAzimuthKept) {
  const TemporaryFolder folder;
  const auto simulated = simulatedScans("spinning-64", 100);
  writeKittiOdometry(folder, simulated);
  const auto scans = openDataset("kitti-odometry", folder.file("data/sequences/04"));
  Points raised = simulated[0].scan.points;
  for (Eigen::Vector3f& p : raised) {
    const Eigen::Vector3f axis = p.cross(Eigen::Vector3f::UnitZ()).normalized();
    p = Eigen::AngleAxisf(static_cast<float>(0.205 * M_PI / 180.0), axis) * p;
  }
  EXPECT_GT(raised[0].z(), simulated[0].scan.points[0].z());
  expectWithoutTimes(scans->read(0), raised, scans->file(0).stamp, 1e-4f);
}

TEST(KittiOdometry, GroundTruthIsMovedFromTheCameraToTheVelodyne) {
  const TemporaryFolder folder;
  writeKittiOdometry(folder, simulatedScans("spinning-16", 50));
  const std::string sequence = folder.file("data/sequences/04/");
  EXPECT_FALSE(openDataset("kitti-odometry", sequence)->groundTruth());
  // The camera 0.3 m before the velodyne, with z forward, x to the right and y down.
  ByteFile()
      .text("P0: 7 0 6 0 0 7 1 0 0 0 1 0\nTr: 0 -1 0 0 0 0 -1 0 1 0 0 -0.3\n")
      .save(sequence + "calib.txt");
  // First at its origin, then after a left turn by 90 degrees, 2 m ahead and 1 m to the right.
  ByteFile()
      .text("1 0 0 0 0 1 0 0 0 0 1 0\n0 0 -1 1 0 1 0 0 1 0 0 2\n")
      .save(folder.file("data/poses/04.txt"));
  const auto truth = openDataset("kitti-odometry", sequence)->groundTruth();
  ASSERT_TRUE(truth);
  ASSERT_EQ(truth->size(), 2u);
  EXPECT_EQ((*truth)[1].stamp.nanoseconds, 1'103'622'400);
  expectPose((*truth)[0].T_world_base, {});
  expectPose((*truth)[1].T_world_base,
             {Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ())),
              {2.3, -1.3, 0.0}});
}

TEST(KittiOdometry, AScanWithoutAStampIsAnError) {
  const TemporaryFolder folder;
  const Paths paths = writeKittiOdometry(folder, simulatedScans("spinning-16", 50));
  std::filesystem::rename(paths[2], folder.file("data/sequences/04/velodyne/000003.bin"));
  try {
    openDataset("kitti-odometry", folder.file("data/sequences/04"));
    FAIL();
  } catch (const DatasetError& error) {
    EXPECT_TRUE(contains(error.what(), "times.txt': has no stamp for scan 3"));
  }
}

TEST(KittiRaw, PointsAreTimedByTheirDirection) {
  const TemporaryFolder folder;
  const auto simulated = simulatedScans("spinning-64", 200);  // clockwise from behind, too
  writeKittiRaw(folder, simulated);
  const auto scans = openDataset("kitti-raw", folder.file("drive"), asStored());
  ASSERT_EQ(scans->size(), 3u);
  const PointCloud cloud = scans->read(1);
  EXPECT_EQ(cloud.stamp.nanoseconds, 1317042145200000002);
  EXPECT_EQ(cloud.fields.back().name, "t");
  const std::vector<std::uint32_t>& truth = simulated[1].nanoseconds;
  ASSERT_EQ(cloud.width, truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == 0) continue;  // exactly behind: of the start or the end of the sweep
    std::uint32_t ns;
    std::memcpy(&ns, &cloud.data[i * cloud.point_step + cloud.fields.back().offset], sizeof(ns));
    ASSERT_NEAR(ns, truth[i], 200.0) << i;
  }
  PointReader reader({});
  EXPECT_TRUE(readWith(reader, cloud).scan);
  EXPECT_TRUE(reader.deskewing()) << reader.description();
}

TEST(KittiRaw, WithoutStartAndEndTheSweepLiesAroundItsStamp) {
  const TemporaryFolder folder;
  writeKittiRaw(folder, simulatedScans("spinning-16", 50));
  const std::string velodyne = folder.file("drive/velodyne_points/");
  std::filesystem::rename(velodyne + "timestamps_start.txt", velodyne + "timestamps.txt");
  const auto scans = openDataset("kitti-raw", folder.file("drive"));
  EXPECT_EQ(scans->read(0).stamp.nanoseconds, 1317042145050000001);
}

TEST(KittiRaw, AMissingScanShiftsNoStamps) {
  const TemporaryFolder folder;
  const Paths paths = writeKittiRaw(folder, simulatedScans("spinning-16", 50));
  std::filesystem::remove(paths[1]);
  const auto scans = openDataset("kitti-raw", folder.file("drive"));
  ASSERT_EQ(scans->size(), 2u);
  EXPECT_EQ(scans->file(1).stamp.nanoseconds, 1317042145300000003);
}

/// As in the drive 2011_09_26_0009.
TEST(KittiRaw, TheStampOfAMissingScanMayBeAnEmptyLine) {
  const TemporaryFolder folder;
  const Paths paths = writeKittiRaw(folder, simulatedScans("spinning-16", 50));
  std::filesystem::remove(paths[1]);
  for (const char* name : {"timestamps_start.txt", "timestamps_end.txt"}) {
    const std::string path = folder.file("drive/velodyne_points/") + name;
    std::string text = textOf(path);
    const std::size_t second = text.find('\n') + 1;
    text.erase(second, text.find('\n', second) - second);
    ByteFile().text(text).save(path);
  }
  const auto scans = openDataset("kitti-raw", folder.file("drive"));
  ASSERT_EQ(scans->size(), 2u);
  EXPECT_EQ(scans->file(1).stamp.nanoseconds, 1317042145300000003);
}

TEST(KittiRaw, GroundTruthIsMovedFromTheImuToTheVelodyne) {
  const TemporaryFolder folder;
  writeKittiRaw(folder, simulatedScans("spinning-16", 50));
  ByteFile()
      .text("calib_time: 25-May-2012 16:47:16\nR: 1 0 0 0 1 0 0 0 1\nT: -0.8 0.3 -0.8\n")
      .save(folder.file("calib_imu_to_velo.txt"));
  ByteFile()
      .text("2011-09-26 13:02:25.15\n2011-09-26 13:02:25.25\n")
      .save(folder.file("drive/oxts/timestamps.txt"));
  std::string others;
  for (int i = 6; i < 30; ++i) others += " 0";
  ByteFile().text("0 8 110 0 0 0" + others).save(folder.file("drive/oxts/data/0000000000.txt"));
  // One arc second to the east, on the equator, and turned to the north.
  ByteFile()
      .text("0 8.000277777777778 111 0 0 1.5707963267948966" + others)
      .save(folder.file("drive/oxts/data/0000000001.txt"));
  const auto truth = openDataset("kitti-raw", folder.file("drive"))->groundTruth();
  ASSERT_TRUE(truth);
  ASSERT_EQ(truth->size(), 2u);
  EXPECT_EQ((*truth)[1].stamp.nanoseconds, 1317042145250000000);
  expectPose((*truth)[0].T_world_base, {Eigen::Quaterniond::Identity(), {0.8, -0.3, 0.8}});
  expectPose((*truth)[1].T_world_base,
             {Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ())),
              {30.9221 + 0.3, 0.8, 1.8}},
             1e-3);
  ByteFile().text("0 1e304 110 0 0 0" + others).save(folder.file("drive/oxts/data/0000000001.txt"));
  EXPECT_THROW(openDataset("kitti-raw", folder.file("drive"))->groundTruth(), DatasetError);
}

}  // namespace
}  // namespace revisit_slam
