// SPDX-License-Identifier: MIT
#include "revisit_slam/session/submap_files.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "revisit_slam/io/pcd.h"
#include "support/random_numbers.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

SubmapPtr submapOf(std::uint32_t id) {
  Submap submap;
  submap.id = SubmapId{id};
  submap.first_scan = ScanId{10 * id};
  submap.T_submap_scan.resize(10);
  submap.stamps.resize(10);
  return std::make_shared<const Submap>(submap);
}

bool contains(const Points& points, const Eigen::Vector3d& wanted) {
  return std::any_of(points.begin(), points.end(), [&](const Eigen::Vector3f& p) {
    return (p.cast<double>() - wanted).norm() < 1e-4;
  });
}

TEST(SubmapFiles, MergesWhereTheGraphPlacesThem) {
  const TemporaryFolder folder;
  SubmapFiles files(folder.file("submaps"));
  // As large as several tiles, and far from the origin.
  const Points a = RandomNumbers(1).cloud(2000, 300.0), b = RandomNumbers(2).cloud(500, 30.0);
  files.add(submapOf(0), a);
  files.add(submapOf(1), b);
  const std::vector<Pose> poses{
      {Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ())), {-150.0, 80.0, 3.0}},
      {Eigen::Quaterniond::Identity(), {1000.0, -2000.0, 0.0}}};
  files.merge(folder.file("map.pcd"), poses, 1e-3);
  const Points merged = readPcdPoints(folder.file("map.pcd"));
  ASSERT_EQ(merged.size(), a.size() + b.size());
  for (const std::size_t i : {0u, 77u, 499u}) {
    EXPECT_TRUE(contains(merged, poses[0] * Eigen::Vector3d(a[i].cast<double>())));
    EXPECT_TRUE(contains(merged, poses[1] * Eigen::Vector3d(b[i].cast<double>())));
  }
}

TEST(SubmapFiles, KeepsOnePointOfAVoxelSeenFromTwoSubmaps) {
  const TemporaryFolder folder;
  SubmapFiles files(folder.file("submaps"));
  for (std::uint32_t id : {0u, 1u}) files.add(submapOf(id), {{10.1f, 20.1f, 0.1f}});
  files.merge(folder.file("map.pcd"), {Pose(), Pose()}, 0.5);
  EXPECT_EQ(readPcdPoints(folder.file("map.pcd")).size(), 1u);
}

TEST(SubmapFiles, TheTableTellsWhichScansASubmapHas) {
  const TemporaryFolder folder;
  SubmapFiles files(folder.file("submaps"));
  files.add(submapOf(0), {{1, 2, 3}});
  files.add(submapOf(1), {});  // nothing seen: no cloud, but a line
  files.writeTable({Pose(), {Eigen::Quaterniond::Identity(), {1.5, 0.0, 0.0}}});
  const std::string table = textOf(folder.file("submaps/submaps.csv"));
  EXPECT_NE(table.find("\n1,0,10,19,0.000000000,1.500000,"), std::string::npos) << table;
}

TEST(SubmapFiles, RefusesAFolderThatCannotBeMade) {
  const TemporaryFolder folder;
  const std::string file = folder.with("taken", "a file");
  EXPECT_THROW(SubmapFiles(file + "/submaps"), std::runtime_error);
}

TEST(Pcd, AStreamOfPiecesIsOneFile) {
  const TemporaryFolder folder;
  PcdStream stream(folder.file("pieces.pcd"));
  stream.write({{1, 2, 3}});
  stream.write({{4, 5, 6}, {7, 8, 9}});
  stream.finish();
  EXPECT_EQ(readPcdPoints(folder.file("pieces.pcd")), (Points{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
  EXPECT_THROW(readPcdPoints(folder.with("bad.pcd", "no cloud")), std::runtime_error);
  EXPECT_THROW(readPcdPoints(folder.file("gone.pcd")), std::runtime_error);
}

}  // namespace
}  // namespace revisit_slam
