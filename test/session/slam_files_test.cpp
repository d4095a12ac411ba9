// SPDX-License-Identifier: MIT
#include "revisit_slam/session/slam_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "revisit_slam/io/g2o.h"
#include "revisit_slam/io/pcd.h"
#include "revisit_slam/slam/slam_config.h"
#include "support/synthetic_street.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

/// Maps and graph of a straight drive through a street, without loops.
class SlamFilesTest : public testing::Test {
 protected:
  void driveThrough(SlamFiles& files) {
    SyntheticStreet street(5, 1);
    MapBuilder builder(config_.mapping, config_.occupancy);
    std::uint32_t id = 0;
    for (const Pose& T : drive(0, 60)) {
      RegisteredScan scan;
      scan.id = ScanId{id++};
      scan.stamp = Stamp::fromSeconds(100.0 + 0.1 * id);
      scan.T_odom_base = T;
      scan.points_base = street.scan(T);
      graph_.add({scan.id, scan.stamp, scan.T_odom_base, Matrix6::Identity()});
      files.add(builder.insert(scan));
    }
    files.add(builder.closeAll());
  }

  SlamConfig config_;
  SlamGraph graph_{config_.backend};
  TemporaryFolder folder_;
};

TEST_F(SlamFilesTest, EveryFileIsThereAndTellsTheSame) {
  SlamFiles files(folder_.file("run"), config_.mapping, config_.occupancy);
  driveThrough(files);
  files.write(graph_);
  const std::size_t scans = graph_.size();
  EXPECT_EQ(readTum(files.file("trajectory.tum")).size(), scans);
  EXPECT_EQ(readG2o(files.file("pose_graph.g2o")).graph.poses().size(), scans);
  for (const char* name : {"trajectory_kitti.txt", "loop_closures.csv", "submaps/submaps.csv",
                           "map.bt", "map.pgm", "map.yaml"})
    EXPECT_GT(std::filesystem::file_size(files.file(name)), 0u) << name;
  EXPECT_GT(readPcdPoints(files.file("map.pcd")).size(), 1000u);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.file("run")))
    EXPECT_NE(entry.path().extension(), ".part");
}

TEST_F(SlamFilesTest, SubmapsAreOnDiskBeforeTheEnd) {
  SlamFiles files(folder_.file("run"), config_.mapping, config_.occupancy);
  driveThrough(files);
  ASSERT_GT(files.submaps().size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(files.file("map.pcd")));
  EXPECT_EQ(readPcdPoints(files.file("submaps/000000.pcd")), files.detail(SubmapId{0}));
}

TEST_F(SlamFilesTest, WithoutOccupancyThereIsNoOctomap) {
  config_.occupancy.enabled = false;
  SlamFiles files(folder_.file("run"), config_.mapping, config_.occupancy);
  driveThrough(files);
  files.write(graph_);
  EXPECT_FALSE(std::filesystem::exists(files.file("map.bt")));
  EXPECT_TRUE(std::filesystem::exists(files.file("map.pcd")));
}

TEST_F(SlamFilesTest, ADriveWithoutRevisitsHasNoConsistency) {
  SlamFiles files(folder_.file("run"), config_.mapping, config_.occupancy);
  driveThrough(files);
  EXPECT_TRUE(files.consistency(graph_).cells.empty());
}

}  // namespace
}  // namespace revisit_slam
