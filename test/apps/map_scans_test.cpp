// SPDX-License-Identifier: MIT
// The example of docs/api.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "revisit_slam/io/trajectory.h"
#include "support/child_process.h"
#include "support/contains.h"
#include "support/synthetic_drive.h"

namespace revisit_slam {
namespace {

void writeBin(const std::string& path, const Points& points) {
  std::ofstream file(path, std::ios::binary);
  for (const Eigen::Vector3f& point : points) {
    const float values[4] = {point.x(), point.y(), point.z(), 0.0f};
    file.write(reinterpret_cast<const char*>(values), sizeof values);
  }
}

/// Slow enough to do without deskewing.
Drive slowDrive() {
  Tangent velocity;
  velocity << 0.5, 0.0, 0.0, 0.0, 0.0, 0.05;
  return driveInRoomWith([&](int) { return velocity; }, 60);
}

TEST(MapScans, LeavesAMapAndTheTrueTrajectory) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("scans"));
  const Drive drive = slowDrive();
  for (std::size_t i = 0; i < drive.scans.size(); ++i)
    writeBin(folder.file("scans/" + std::to_string(1000 + i) + ".bin"), drive.scans[i].points);
  ChildProcess program({REVISIT_SLAM_EXAMPLE_PROGRAM, folder.file("scans"), folder.file("result")});
  ASSERT_EQ(program.wait(60.0), 0) << program.output();
  EXPECT_TRUE(contains(program.output(), "59: "));
  EXPECT_TRUE(contains(program.output(), "the map is in " + folder.file("result")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("result/map.pcd")));

  const Trajectory trajectory = readTum(folder.file("result/trajectory.tum"));
  ASSERT_EQ(trajectory.size(), drive.scans.size());
  const Pose T_base_sensor = drive.scans.front().T_base_sensor;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Pose T_first_sensor = (drive.T_first_base.front() * T_base_sensor).inverse() *
                                drive.T_first_base[i] * T_base_sensor;
    const Pose estimate = trajectory.front().T_world_base.inverse() * trajectory[i].T_world_base;
    EXPECT_LT((estimate.translation - T_first_sensor.translation).norm(), 0.1) << i;
  }
}

TEST(MapScans, SaysWhyItCannot) {
  ChildProcess program({REVISIT_SLAM_EXAMPLE_PROGRAM, "/nowhere", "/nowhere/either"});
  EXPECT_EQ(program.wait(10.0), 1);
  EXPECT_TRUE(contains(program.output(), "map_scans: "));
}

}  // namespace
}  // namespace revisit_slam
