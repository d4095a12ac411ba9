// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rosbag/view.h>

#include "datasets/dataset_writers.h"
#include "datasets/simulated_scans.h"
#include "revisit_slam/datasets/open_dataset.h"
#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/ros/input/point_fields.h"
#include "support/child_process.h"
#include "support/contains.h"

namespace revisit_slam {
namespace {

struct Conversion {
  Conversion(const std::string& dataset, const std::string& folder, const std::string& bag,
             const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments{REVISIT_SLAM_CONVERT_PROGRAM, dataset, folder, "--out", bag};
    arguments.insert(arguments.end(), options.begin(), options.end());
    ChildProcess process(arguments);
    status = process.wait(60.0);
    output = process.output();
  }
  int status = 0;
  std::string output;
};

TEST(ConvertDataset, ABagWithTheScansAndTheGroundTruthBesideIt) {
  const TemporaryFolder folder;
  const auto simulated = simulatedScans("spinning-16", 100);
  writeApollo(folder, simulated);
  const std::string bag = folder.file("drive.bag");
  const Conversion run("apollo", folder.file(""), bag, {"--topic", "/lidar", "--max-scans", "2"});
  ASSERT_EQ(run.status, 0) << run.output;
  BagScans scans({bag}, "");
  EXPECT_EQ(scans.topic(), "/lidar");
  ASSERT_EQ(scans.size(), 2u);
  const auto dataset = openDataset("apollo", folder.file(""));
  std::uint32_t i = 0;
  for (const rosbag::MessageInstance& instance : scans.messages()) {
    const auto message = instance.instantiate<sensor_msgs::PointCloud2>();
    sensor_msgs::PointCloud2 expected = toPointCloud2(dataset->read(i));
    expected.header.seq = i++;
    EXPECT_EQ(*message, expected);
    EXPECT_EQ(instance.getTime(), expected.header.stamp);
  }
  EXPECT_EQ(readTum(folder.file("drive.gt.tum")).size(), 3u);
}

TEST(ConvertDataset, DamagedScansAreSkippedNamedAndCounted) {
  const TemporaryFolder folder;
  const Paths paths = writeKittiOdometry(folder, simulatedScans("spinning-16", 50));
  std::filesystem::resize_file(paths[1], 33);
  const std::string bag = folder.file("drive.bag");
  const Conversion run("kitti-odometry", folder.file("data/sequences/04"), bag);
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(contains(run.output, "000001.bin': 33 bytes"));
  EXPECT_TRUE(contains(run.output, "1 damaged scans were skipped"));
  EXPECT_EQ(BagScans({bag}, "").size(), 2u);
}

TEST(ConvertDataset, WithoutOneGoodScanThereIsNoBag) {
  const TemporaryFolder folder;
  for (const std::string& path : writeKittiOdometry(folder, simulatedScans("spinning-16", 50)))
    std::filesystem::resize_file(path, 33);
  const std::string sequence = folder.file("data/sequences/04"), bag = folder.file("drive.bag");
  const Conversion run("kitti-odometry", sequence, bag);
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.output, "not one scan"));
  for (const auto& entry : std::filesystem::directory_iterator(folder.file("")))
    EXPECT_EQ(entry.path().filename(), "data");
}

TEST(ConvertDataset, AnUnknownNameIsRefused) {
  const Conversion run("nuscenes", "/nowhere", "/nowhere/drive.bag");
  EXPECT_NE(run.status, 0);
  EXPECT_TRUE(contains(run.output, "newer-college"));
}

}  // namespace
}  // namespace revisit_slam
