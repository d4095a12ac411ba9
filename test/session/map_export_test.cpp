// SPDX-License-Identifier: MIT
#include "revisit_slam/session/map_export.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "revisit_slam/io/g2o.h"
#include "revisit_slam/io/pcd.h"
#include "revisit_slam/session/stored_submap.h"
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

/// Of a map that a sensor with intensities goes on with.
TEST_F(MapExportTest, PointsHaveIntensitiesWhereSubmapsHave) {
  for (const SubmapClosed& submap : session_.submaps) {
    const std::string path = submapFile(session_.folder, submap.id, session_.info.id);
    MapUpdate update = readSubmap(path, {SubmapRecord::trajectory, SubmapRecord::detail});
    update.intensities.assign(update.detail_submap.size(), static_cast<float>(submap.id.value + 1));
    std::ofstream(path, std::ios::binary) << encodeSubmap(update);
  }
  ExportConfig config;
  config.occupancy = false;
  makeAll(config);
  pcl::PointCloud<pcl::PointXYZI> map;
  ASSERT_EQ(pcl::io::loadPCDFile(out("map.pcd"), map), 0);
  std::map<int, int> points_of;
  for (const pcl::PointXYZI& point : map) ++points_of[static_cast<int>(point.intensity)];
  EXPECT_EQ(points_of.size(), session_.submaps.size());
  for (const auto& [submap, points] : points_of) EXPECT_GT(points, 10) << submap;
  EXPECT_TRUE(contains(textOf(out("submaps/000000.pcd")), "FIELDS x y z intensity"));
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

TEST_F(MapExportTest, TheMapCanBeExportedInTheFrameOfTheEarth) {
  makeAll();
  const Points all_map = readPcdPoints(out("map.pcd"));
  Georeference georeference;
  georeference.datum = {48.1, 11.6, 520.0};
  georeference.T_enu_map.translation = {100.0, 200.0, 3.0};
  session_.graph.georeference = georeference;
  ExportConfig config;
  config.frame.kind = MapFrame::Kind::enu;
  makeAll(config);
  const Points all_enu = readPcdPoints(out("map.pcd"));
  ASSERT_EQ(all_enu.size(), all_map.size());
  for (std::size_t i = 0; i < all_map.size(); ++i)
    EXPECT_LT((all_enu[i] - all_map[i] - Eigen::Vector3f(100, 200, 3)).norm(), 1e-4f);
  config.frame.kind = MapFrame::Kind::utm;
  EXPECT_THROW(exportSession(session_, folder_.file("utm"), config), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("utm")));
  config.clouds = {"las"};
  exportSession(session_, folder_.file("utm"), config);
  EXPECT_GT(std::filesystem::file_size(folder_.file("utm/map.las")), all_map.size() * 20);
}

TEST_F(MapExportTest, TilesOfTheExportBeforeAreRemoved) {
  const auto tilesOf = [&](double edge) {
    ExportConfig config;
    config.tile = edge;
    makeAll(config);
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(out("map_tiles")))
      names.insert(entry.path().filename().string());
    return names;
  };
  const std::set<std::string> coarse = tilesOf(100.0);
  EXPECT_GT(tilesOf(20.0).size(), coarse.size());
  std::ofstream(out("map_tiles/notes.txt")) << "of the user";
  std::set<std::string> again = tilesOf(100.0);
  EXPECT_EQ(again.erase("notes.txt"), 1u);
  EXPECT_EQ(again, coarse);
}

/// A disk that is full, say.
TEST_F(MapExportTest, AFileThatCannotBeWrittenIsAnError) {
  for (const char* name : {"map.bt.part", "map.pgm.part"}) {
    std::filesystem::create_directories(out(name) + "/in the way");
    EXPECT_THROW(exportSession(session_, folder_.file("out")), std::runtime_error) << name;
    std::filesystem::remove_all(out(name));
  }
  makeAll();
}

/// A drive along a wall, 12 m and back; in three of its scans somebody is in between.
class WalkerDrive {
 public:
  static constexpr int kScans = 50;

  /// With so many metres between scans.
  explicit WalkerDrive(double step = 0.5) : step_(step) {}

  void write(const std::string& folder) {
    StoredParameters parameters;
    MapBuilder builder(parameters.mapping, parameters.occupancy);
    SessionWriter writer({folder, "", nullptr, false}, someInfo(), 0);
    std::vector<GraphNode> nodes;
    const auto keep = [&](MapUpdate update) {
      if (!update.submap) return;
      const auto closed = std::make_shared<const MapUpdate>(std::move(update));
      writer.add(std::exchange(nodes, {}), closedOf(*closed->submap, closed->detail_submap),
                 closed);
    };
    for (int k = 0; k < kScans; ++k) {
      RegisteredScan scan;
      scan.id = ScanId{static_cast<std::uint32_t>(k)};
      scan.stamp = Stamp::fromSeconds(100.0 + k);
      scan.T_odom_base.translation.x() = 12.0 - std::abs(k - kScans / 2) * step_;
      scan.sensor_base = {0.0, 0.0, 1.5};
      scan.points_base = pointsFrom(scan.T_odom_base.translation.cast<float>(), k);
      nodes.push_back({scan.id, scan.stamp, scan.T_odom_base, Matrix6::Identity()});
      keep(builder.insert(scan));
    }
    keep(builder.closeAll());
    writer.close();
  }

  static bool isWalker(const Eigen::Vector3f& p) {
    return std::abs(p.y() - 3.0f) < 0.5f && p.z() > 0.3f;
  }

 private:
  Points pointsFrom(const Eigen::Vector3f& base, int scan) const {
    Points points;
    const auto take = [&](float x, float y, float z) {
      points.emplace_back(Eigen::Vector3f(x, y, z) - base);
    };
    for (float x = base.x() - 20.0f; x < base.x() + 20.0f; x += 0.1f) {
      for (float y = -3.0f; y < 6.0f; y += 0.2f) take(x, y, 0.05f);
      for (float z = 0.05f; z < 4.0f; z += 0.1f) take(x, 6.05f, z);
    }
    if (scan >= 12 && scan < 15)
      for (float z = 0.4f; z < 1.7f; z += 0.1f)
        for (float x = 6.0f; x < 6.4f; x += 0.1f) take(x, 3.05f, z);
    return points;
  }

  double step_;
};

TEST_F(MapExportTest, WhatMovedIsBesideTheMapAndOutOfItsOccupancy) {
  WalkerDrive().write(folder_.file("walker"));
  std::vector<std::string> notices;
  session_ = readSession(folder_.file("walker"), notices);
  StoredParameters parameters;
  parameters.mapping.dynamic_points.rays = 1;  // the wall has few points
  parameters.occupancy.miss = 0.5;             // rays alone clear nothing
  session_.info.parameters = textOf(parametersOf(parameters));
  makeAll();
  const Points all = readPcdPoints(out("map.pcd"));
  const std::string occupied = textOf(out("map.bt"));
  const auto walkers = std::count_if(all.begin(), all.end(), WalkerDrive::isWalker);
  EXPECT_GT(walkers, 10);
  EXPECT_FALSE(std::filesystem::exists(out("map_dynamic.pcd")));
  ExportConfig config;
  config.remove_dynamic = true;
  makeAll(config);
  const Points kept = readPcdPoints(out("map.pcd")), moved = readPcdPoints(out("map_dynamic.pcd"));
  EXPECT_EQ(kept.size() + moved.size(), all.size());
  EXPECT_TRUE(std::all_of(moved.begin(), moved.end(), WalkerDrive::isWalker));
  EXPECT_GT(static_cast<double>(moved.size()), 0.8 * static_cast<double>(walkers));
  EXPECT_TRUE(textOf(out("map.bt")) != occupied);
}

TEST_F(MapExportTest, ASessionThatDoesNotTellWhenPointsWereSeenKeepsThemAllAndSaysSo) {
  for (const SubmapClosed& submap : session_.submaps) {
    const std::string path = submapFile(session_.folder, submap.id);
    MapUpdate update = readSubmap(path, {SubmapRecord::trajectory, SubmapRecord::detail});
    std::ofstream(path, std::ios::binary) << encodeSubmap(update);
  }
  makeAll();
  const Points all = readPcdPoints(out("map.pcd"));
  ExportConfig config;
  config.remove_dynamic = true;
  const std::vector<std::string> notices = exportSession(session_, folder_.file("out"), config);
  ASSERT_FALSE(notices.empty());
  EXPECT_TRUE(contains(notices.front(), "do not tell when their points were seen"));
  EXPECT_EQ(readPcdPoints(out("map.pcd")), all);
  EXPECT_TRUE(readPcdPoints(out("map_dynamic.pcd")).empty());
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

TEST_F(MapExportTest, ConsistencyIsJudgedWithoutTheSubmapsThatAreMissing) {
  WalkerDrive(4.0).write(folder_.file("walker"));
  std::vector<std::string> notices;
  session_ = readSession(folder_.file("walker"), notices);
  ASSERT_FALSE(consistencyOf(session_).cells.empty());
  std::filesystem::remove(submapFile(session_.folder, session_.submaps.back().id));
  EXPECT_TRUE(consistencyOf(session_).cells.empty());
}

TEST_F(MapExportTest, ADriveWithoutRevisitsHasNoConsistency) {
  EXPECT_TRUE(consistencyOf(session_).cells.empty());
}

}  // namespace
}  // namespace revisit_slam
