// SPDX-License-Identifier: MIT
#include <nav_msgs/Path.h>
#include <sensor_msgs/Image.h>
#include <visualization_msgs/MarkerArray.h>

#include <filesystem>
#include <set>

#include "drive_with_loops.h"
#include "revisit_slam/io/trajectory.h"

namespace revisit_slam {
namespace {

std::vector<std::string> entriesOf(const std::string& folder) {
  std::set<std::string> entries;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    entries.insert(entry.path().string());
  return {entries.begin(), entries.end()};
}

std::vector<LiveSlam::CloudPtr> firstScans(std::size_t count) {
  const auto& clouds = DriveWithLoops::get().clouds;
  return {clouds.begin(), clouds.begin() + static_cast<std::ptrdiff_t>(count)};
}

TEST(Sessions, eachHasAFolderAndNothingOfTheFirstIsLostByAReset) {
  const TemporaryFolder folder;
  LiveSlam slam("reset", folder.file("drives"));
  slam.load();
  slam.play(firstScans(200));
  ASSERT_TRUE(slam.trigger("odometry/reset").success);
  slam.play(firstScans(150));
  const auto finished = slam.trigger("back_end/finish");
  ASSERT_TRUE(finished.success) << finished.message;

  const std::vector<std::string> drives = entriesOf(folder.file("drives"));
  ASSERT_EQ(drives.size(), 2u);
  EXPECT_EQ(drives[1], drives[0] + "_2");  // they began at the same instant
  EXPECT_EQ(readTum(drives[0] + "/trajectory.tum").size(), 200u);
  EXPECT_EQ(readTum(drives[1] + "/trajectory.tum").size(), 150u);
  for (const std::string& drive : drives)
    for (const char* name : {"/map.pcd", "/pose_graph.g2o", "/submaps/submaps.csv"})
      EXPECT_TRUE(std::filesystem::exists(drive + name)) << drive << name;

  EXPECT_TRUE(becomesTrue([&] {
    std::set<SessionId> sessions;
    for (const auto& maps : slam.copyOf(slam.maps)) sessions.insert(maps->submap->id.session);
    return sessions.size() == 2;
  }));
  EXPECT_LT(slam.copyOf(slam.maps).back()->submap->first_scan.value, 150u);
}

TEST(Sessions, whatWasDrivenIsOnDiskWhenTheNodeletsEndUnasked) {
  const TemporaryFolder folder;
  LiveSlam slam("shutdown", folder.file("drives"));
  slam.load();
  slam.play(firstScans(120));
  // Scans that are still on their way to the back-end end with the nodelets.
  ASSERT_TRUE(becomesTrue([&] { return slam.save(folder.file("asked")).scans == 120; }));
  slam.unload();
  const std::vector<std::string> drives = entriesOf(folder.file("drives"));
  ASSERT_EQ(drives.size(), 1u);
  EXPECT_EQ(readTum(drives[0] + "/trajectory.tum").size(), 120u);
}

TEST(Sessions, aFolderThatIsDeletedDuringTheDriveIsWrittenAnew) {
  const TemporaryFolder folder;
  LiveSlam slam("deleted", folder.file("drives"));
  slam.load();
  const auto& clouds = DriveWithLoops::get().clouds;
  slam.play({clouds.begin(), clouds.begin() + 60});
  const std::string drive = entriesOf(folder.file("drives")).at(0);
  const std::string odometry = drive + "/odometry.tum";
  ASSERT_TRUE(becomesTrue(
      [&] { return std::filesystem::exists(odometry) && readTum(odometry).size() == 60; }));
  std::filesystem::remove_all(drive);
  slam.play({clouds.begin() + 60, clouds.begin() + 120});
  const auto finished = slam.trigger("back_end/finish");
  EXPECT_TRUE(finished.success) << finished.message;
  EXPECT_EQ(readTum(drive + "/trajectory.tum").size(), 120u);
  EXPECT_EQ(readTum(odometry).size(), 60u);  // those after
  for (const char* name : {"/run.json", "/map.pcd", "/graph.log"})
    EXPECT_TRUE(std::filesystem::exists(drive + name)) << name;
}

TEST(Sessions, savingNeedsAFolderAndSomethingToSave) {
  LiveSlam slam("saving");
  slam.load();
  EXPECT_FALSE(slam.save("").success);
  EXPECT_TRUE(slam.trigger("back_end/finish").message == "there is nothing to finish");
  slam.play(firstScans(30));
  EXPECT_FALSE(slam.save("").success);
  EXPECT_FALSE(slam.save("/proc/nowhere").success);
  const TemporaryFolder folder;
  const SaveMap::Response saved = slam.save(folder.file("a/b"));
  EXPECT_EQ(saved.success, saved.submaps > 0) << saved.message;
  if (!saved.success) {
    EXPECT_NE(saved.message.find("no submap is closed"), std::string::npos);
  }
  EXPECT_EQ(readTum(folder.file("a/b/trajectory.tum")).size(), saved.scans);
}

TEST(Display, comesToThoseWhoListenLate) {
  LiveSlam slam("display");
  slam.load();
  slam.play(firstScans(200));
  ASSERT_TRUE(slam.trigger("back_end/finish").success);
  std::mutex mutex;
  std::set<std::string> seen;
  const auto note = [&](const std::string& topic, bool filled) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (filled) seen.insert(topic);
  };
  std::vector<ros::Subscriber> subscribers;
  for (const std::string topic : {"local_maps", "submaps", "map_cloud"})
    subscribers.push_back(slam.node().subscribe<sensor_msgs::PointCloud2>(
        topic, 10, [&, topic](const sensor_msgs::PointCloud2::ConstPtr& cloud) {
          note(topic, cloud->width > 1000 && cloud->header.frame_id == "map");
        }));
  for (const std::string topic : {"map_outlines", "keyposes"})
    subscribers.push_back(slam.node().subscribe<visualization_msgs::MarkerArray>(
        topic, 10, [&, topic](const visualization_msgs::MarkerArray::ConstPtr& array) {
          note(topic, array->markers.size() > 1);
        }));
  subscribers.push_back(slam.node().subscribe<nav_msgs::Path>(
      "path", 10,
      [&](const nav_msgs::Path::ConstPtr& path) { note("path", path->poses.size() > 20); }));
  subscribers.push_back(slam.node().subscribe<sensor_msgs::Image>(
      "density_image", 10, [&](const sensor_msgs::Image::ConstPtr& image) {
        note("density_image", image->width > 100);
      }));
  EXPECT_TRUE(becomesTrue([&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return seen.size() == 7;
  })) << ::testing::PrintToString(seen);
  for (ros::Subscriber& subscriber : subscribers) subscriber.shutdown();
}

}  // namespace
}  // namespace revisit_slam
