// SPDX-License-Identifier: MIT
#include "revisit_slam/session/map_export.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "revisit_slam/io/g2o.h"
#include "revisit_slam/io/pcd.h"
#include "session/session_fixtures.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

class MapExportTest : public testing::Test {
 protected:
  MapExportTest() {
    writeStreetSession(folder_.file("session"));
    std::vector<std::string> notices;
    session_ = readSession(folder_.file("session"), notices);
  }

  std::string out(const std::string& name) const { return folder_.file("out/" + name); }
  void makeAll(const ExportConfig& config = {}) {
    EXPECT_TRUE(exportSession(session_, folder_.file("out"), config).empty());
  }

  TemporaryFolder folder_;
  Session session_;
};

TEST_F(MapExportTest, EveryFileIsThereAndTellsTheSame) {
  makeAll();
  const std::size_t scans = session_.graph.nodes.size();
  EXPECT_EQ(readTum(out("trajectory.tum")).size(), scans);
  EXPECT_EQ(readG2o(out("pose_graph.g2o")).graph.poses().size(), scans);
  for (const char* name : {"trajectory_kitti.txt", "loop_closures.csv", "submaps/submaps.csv",
                           "map.bt", "map.pgm", "map.yaml"})
    EXPECT_GT(std::filesystem::file_size(out(name)), 0u) << name;
  EXPECT_GT(readPcdPoints(out("map.pcd")).size(), 1000u);
  EXPECT_EQ(readPcdPoints(out("submaps/000000.pcd")),
            StreetDrive::get().updates.front()->detail_submap);
  EXPECT_TRUE(contains(textOf(out("submaps/submaps.csv")), "\n1,0,6,11,"));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.file("out")))
    EXPECT_NE(entry.path().extension(), ".part");
}

TEST_F(MapExportTest, TheMapHasOnePointForAVoxelWhereTheGraphPutsIt) {
  session_.graph.T_map_scan[session_.submaps[0].first_scan.value].translation = {1000, -2000, 5};
  ExportConfig config;
  config.resolution = 1.0;
  makeAll(config);
  const Points coarse = readPcdPoints(out("map.pcd"));
  std::set<std::tuple<int, int, int>> voxels;
  for (const Eigen::Vector3f& p : coarse)
    voxels.emplace(std::floor(p.x()), std::floor(p.y()), std::floor(p.z()));
  EXPECT_GT(static_cast<double>(voxels.size()), 0.99 * static_cast<double>(coarse.size()));
  EXPECT_TRUE(std::any_of(coarse.begin(), coarse.end(),
                          [](const Eigen::Vector3f& p) { return p.y() < -1900.0f; }));
  makeAll();
  EXPECT_GT(readPcdPoints(out("map.pcd")).size(), 3 * coarse.size());
}

TEST_F(MapExportTest, TilesTogetherAreTheMap) {
  makeAll();
  ExportConfig config;
  config.tile = 50.0;
  config.clouds = {"pcd", "ply"};
  makeAll(config);
  std::size_t points = 0, files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out("map_tiles"))) {
    ++files;
    if (entry.path().extension() != ".pcd") continue;
    const Points tile = readPcdPoints(entry.path());
    points += tile.size();
    const float x = std::floor(tile.front().x() / 50.0f);
    for (const Eigen::Vector3f& p : tile) EXPECT_EQ(std::floor(p.x() / 50.0f), x);
  }
  EXPECT_GT(files, 4u);
  EXPECT_NEAR(static_cast<double>(points),
              static_cast<double>(readPcdPoints(out("map.pcd")).size()), 0.01 * points);
}

TEST_F(MapExportTest, AMapBeyondAnOctreeIsTiledAndTheRestIsMade) {
  const std::uint32_t last = session_.submaps.back().first_scan.value;
  session_.graph.T_map_scan[last].translation.x() = 20'000.0;
  const std::vector<std::string> notices = exportSession(session_, folder_.file("out"));
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_TRUE(contains(notices.front(), "map_tiles/octomap.csv"));
  EXPECT_FALSE(std::filesystem::exists(out("map.bt")));
  EXPECT_TRUE(std::filesystem::exists(out("map_tiles/map_0_0.bt")));
  EXPECT_TRUE(std::filesystem::exists(out("map_tiles/map_1_0.bt")));
  EXPECT_TRUE(std::filesystem::exists(out("map.pcd")));
}

TEST_F(MapExportTest, WithoutASubmapItSaysThatThereIsNoMap) {
  session_.submaps.clear();
  const std::vector<std::string> notices = exportSession(session_, folder_.file("out"));
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_TRUE(contains(notices.front(), "no submap is closed"));
  EXPECT_TRUE(std::filesystem::exists(out("trajectory.tum")));
}

TEST_F(MapExportTest, ADriveWithoutRevisitsHasNoConsistency) {
  EXPECT_TRUE(consistencyOf(session_).cells.empty());
}

}  // namespace
}  // namespace revisit_slam
