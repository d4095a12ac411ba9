// SPDX-License-Identifier: MIT
#include "revisit_slam/io/pcd.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include "support/random_numbers.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

TEST(Pcd, ReadsBackTheSameBits) {
  const TemporaryFolder folder;
  for (const std::size_t count : {1u, 7u, 5000u}) {
    const Points points = RandomNumbers(1).cloud(count, 1000.0);
    writePcd(folder.file("map.pcd"), points);
    pcl::PointCloud<pcl::PointXYZ> read;
    ASSERT_EQ(pcl::io::loadPCDFile(folder.file("map.pcd"), read), 0);
    ASSERT_EQ(read.size(), count);
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_EQ(Eigen::Vector3f(read[i].getVector3fMap()), points[i]);
  }
}

TEST(Pcd, IntensitiesAreAFieldOfThePoints) {
  const TemporaryFolder folder;
  const Points points = RandomNumbers(2).cloud(100, 10.0);
  std::vector<float> intensities;
  for (std::size_t i = 0; i < points.size(); ++i)
    intensities.push_back(0.5f * static_cast<float>(i));
  writePcd(folder.file("map.pcd"), points, intensities);
  pcl::PointCloud<pcl::PointXYZI> read;
  ASSERT_EQ(pcl::io::loadPCDFile(folder.file("map.pcd"), read), 0);
  ASSERT_EQ(read.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(Eigen::Vector3f(read[i].getVector3fMap()), points[i]);
    EXPECT_EQ(read[i].intensity, intensities[i]);
  }
  EXPECT_EQ(readPcdPoints(folder.file("map.pcd")), points);
}

TEST(Pcd, RefusesAnEmptyCloudAndKeepsTheOldFile) {
  const TemporaryFolder folder;
  const std::string path = folder.with("map.pcd", "old");
  EXPECT_THROW(writePcd(path, {}), std::runtime_error);
  EXPECT_EQ(textOf(path), "old");
}

TEST(Pcd, FailsWhereItCannotWrite) {
  EXPECT_THROW(writePcd(TemporaryFolder().file("gone/map.pcd"), {{1, 2, 3}}), std::runtime_error);
}

}  // namespace
}  // namespace revisit_slam
