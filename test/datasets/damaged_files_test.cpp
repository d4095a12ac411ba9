// SPDX-License-Identifier: MIT
// A damaged scan of any dataset is an error that names its file, and the others can still be read.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "datasets/dataset_writers.h"
#include "datasets/simulated_scans.h"
#include "revisit_slam/datasets/open_dataset.h"
#include "support/contains.h"

namespace revisit_slam {
namespace {

namespace fs = std::filesystem;

struct Written {
  std::string root;
  Paths paths;
};

Written write(const std::string& dataset, const TemporaryFolder& folder) {
  const auto scans = simulatedScans("spinning-16", 50);
  if (dataset == "helipr-ouster") return {folder.file(""), writeHelipr(folder, "Ouster", scans)};
  if (dataset == "helipr-avia") return {folder.file(""), writeHelipr(folder, "Avia", scans)};
  if (dataset == "helipr-aeva") return {folder.file(""), writeHelipr(folder, "Aeva", scans)};
  if (dataset == "helipr-velodyne")
    return {folder.file(""), writeHelipr(folder, "Velodyne", scans)};
  if (dataset == "mulran") return {folder.file(""), writeMulran(folder, scans)};
  if (dataset == "apollo") return {folder.file(""), writeApollo(folder, scans)};
  if (dataset == "newer-college") return {folder.file(""), writeNewerCollege(folder, scans)};
  if (dataset == "kitti-raw") return {folder.file("drive"), writeKittiRaw(folder, scans)};
  return {folder.file("data/sequences/04"), writeKittiOdometry(folder, scans)};
}

class DamagedFiles : public ::testing::TestWithParam<std::string> {
 protected:
  DamagedFiles() : written_(write(GetParam(), folder_)) {}

  /// Opens the dataset, damages its second scan and reads all three.
  void expectSecondScanSkipped(const std::function<void(const std::string& path)>& damage) const {
    const auto scans = openDataset(GetParam(), written_.root);
    damage(written_.paths[1]);
    EXPECT_GT(scans->read(0).width, 100u);
    try {
      scans->read(1);
      ADD_FAILURE() << "was read";
    } catch (const DatasetError& error) {
      EXPECT_TRUE(contains(error.what(), fs::path(written_.paths[1]).filename().string()));
    }
    EXPECT_GT(scans->read(2).width, 100u);
  }

  TemporaryFolder folder_;
  Written written_;
};

TEST_P(DamagedFiles, TruncatedWithinAPoint) {
  expectSecondScanSkipped(
      [](const std::string& path) { fs::resize_file(path, fs::file_size(path) / 2 | 1); });
}

TEST_P(DamagedFiles, Empty) {
  expectSecondScanSkipped([](const std::string& path) { fs::resize_file(path, 0); });
}

TEST_P(DamagedFiles, Missing) {
  expectSecondScanSkipped([](const std::string& path) { fs::remove(path); });
}

TEST_P(DamagedFiles, OfAnotherKind) {
  expectSecondScanSkipped(
      [](const std::string& path) { ByteFile().text("<html>Not Found</html>\n.").save(path); });
}

TEST_P(DamagedFiles, AFolderWithoutScansIsNamed) {
  for (const std::string& path : written_.paths) fs::remove(path);
  EXPECT_THROW(openDataset(GetParam(), written_.root), DatasetError);
  try {
    openDataset(GetParam(), "/nowhere/at/all");
    ADD_FAILURE() << "was opened";
  } catch (const DatasetError& error) {
    EXPECT_TRUE(contains(error.what(), "/nowhere/at/all"));
  }
}

INSTANTIATE_TEST_SUITE_P(All, DamagedFiles, ::testing::ValuesIn(datasetNames()));

TEST(DamagedPoints, NotANumberIsCountedAndLeftOut) {
  const TemporaryFolder folder;
  auto simulated = simulatedScans("spinning-16", 50);
  Points& points = simulated[0].scan.points;
  points[3].x() = std::numeric_limits<float>::quiet_NaN();
  points[4].z() = std::numeric_limits<float>::infinity();
  writeKittiRaw(folder, simulated);
  const auto scans = openDataset("kitti-raw", folder.file("drive"));
  PointReader reader({});
  const ScanReading reading = readWith(reader, scans->read(0));
  ASSERT_TRUE(reading.scan);
  EXPECT_EQ(reading.counts.not_finite, 2u);
  EXPECT_EQ(reading.counts.kept, points.size() - 2);
}

TEST(DamagedGroundTruth, FileAndLineAreNamedAndScansAreRead) {
  const TemporaryFolder folder;
  writeMulran(folder, simulatedScans("spinning-16", 50));
  const std::string good = "1700000000500000001,1,0,0,1,0,1,0,2,0,0,1,3\n";
  for (const std::string bad : {"1700000000600000001,1,0,0,1,0,1,0,2,0\n",
                                "1700000000600000001,1,0,0,nan,0,1,0,2,0,0,1,3\n",
                                "1700000000600000001,1,0,0,1,0,1,0,2,0,0,1,x\n",
                                "1700000000600000001,0,0,0,1,0,0,0,2,0,0,0,3\n",
                                "99999999999999999999,1,0,0,1,0,1,0,2,0,0,1,3\n"}) {
    ByteFile().text(good + bad).save(folder.file("global_pose.csv"));
    const auto scans = openDataset("mulran", folder.file(""));
    EXPECT_EQ(scans->read(0).width, 65536u);
    try {
      scans->groundTruth();
      ADD_FAILURE() << bad;
    } catch (const DatasetError& error) {
      EXPECT_TRUE(contains(error.what(), "global_pose.csv': line 2: "));
    }
  }
}

TEST(DamagedGroundTruth, NumbersThatNobodyWritesOverflowNothing) {
  const TemporaryFolder folder;
  writeNewerCollege(folder, simulatedScans("spinning-16", 50));
  for (const char* stamp : {"8999999999999999999,0", "-1,0", "1,8999999999999999999", "1,-1"}) {
    ByteFile()
        .text(std::string(stamp) + ",0,0,0,0,0,0,1\n")
        .save(folder.file("ground_truth/registered_poses.csv"));
    EXPECT_THROW(openDataset("newer-college", folder.file(""))->groundTruth(), DatasetError);
  }
  writeKittiRaw(folder, simulatedScans("spinning-16", 50));
  for (const std::string& seconds : {std::string("8999999999"), std::string(1 << 20, '1')}) {
    ByteFile()
        .text("2099-12-31 23:59:" + seconds + "\n")
        .save(folder.file("drive/velodyne_points/timestamps_end.txt"));
    EXPECT_THROW(openDataset("kitti-raw", folder.file("drive")), DatasetError);
  }
}

TEST(UnknownDataset, TheKnownOnesAreListed) {
  try {
    openDataset("nuscenes", "/nowhere");
    FAIL();
  } catch (const DatasetError& error) {
    EXPECT_TRUE(contains(error.what(), "nuscenes"));
    EXPECT_TRUE(contains(error.what(), "helipr-ouster"));
    EXPECT_TRUE(contains(error.what(), "kitti-raw"));
  }
}

}  // namespace
}  // namespace revisit_slam
