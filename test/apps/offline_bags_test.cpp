// SPDX-License-Identifier: MIT
// Bags that cannot be used: the offline program says what is wrong and what to do.
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>

#include <filesystem>

#include "support/contains.h"
#include "support/offline_program.h"
#include "support/scan_bag.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

TEST(OfflineBags, missingFileIsNamed) {
  const OfflineProgram run("/nowhere/drive.bag");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.output, "/nowhere/drive.bag"));
}

TEST(OfflineBags, missingTopicListsTheTopicsWithScans) {
  const TemporaryFolder folder;
  const std::string bag = folder.file("drive.bag");
  writeScanBag(bag, toClouds(driveInRoom(1)), "/front/points");
  const OfflineProgram run(bag, {"--topic", "/points"});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.output,
                       "no topic '/points'; choose with --points (points:= in launch files) one "
                       "of: /front/points"));
}

TEST(OfflineBags, missingTopicOfMotionListsTheTopicsOfItsType) {
  const TemporaryFolder folder;
  const std::string bag = folder.file("drive.bag");
  writeScanBag(bag, toClouds(driveInRoom(1)));
  {
    rosbag::Bag more(bag, rosbag::bagmode::Append);
    nav_msgs::Odometry odometry;
    odometry.header.stamp = ros::Time(1.0);
    more.write("/wheels", odometry.header.stamp, odometry);
  }
  const OfflineProgram run(bag, {"--set", "priors/odometry_topic=/odom"});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.output,
                       "no topic '/odom' of type nav_msgs/Odometry, which "
                       "priors/odometry_topic needs; topics of this type: /wheels"));
}

TEST(OfflineBags, bagCutOffAsksForReindexing) {
  const TemporaryFolder folder;
  const std::string bag = folder.file("drive.bag");
  writeScanBag(bag, toClouds(driveInRoom(20)));
  std::filesystem::resize_file(bag, std::filesystem::file_size(bag) / 2);
  const OfflineProgram run(bag);
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.output, "rosbag reindex " + bag));
}

TEST(OfflineBags, recordingThatWasNotClosedAsksForReindexing) {
  const TemporaryFolder folder;
  const std::string closed = folder.file("closed.bag"), open = folder.file("open.bag");
  rosbag::Bag bag(closed, rosbag::bagmode::Write);
  for (const auto& cloud : toClouds(driveInRoom(20)))
    bag.write("/points", cloud.header.stamp, cloud);
  std::filesystem::copy_file(closed, open);
  bag.close();
  const OfflineProgram run(open);
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.output, "rosbag reindex " + open));
}

TEST(OfflineBags, fileOfAnotherKindIsRefused) {
  const TemporaryFolder folder;
  const OfflineProgram run(folder.with("drive.bag", "not a bag\n"));
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.output, "drive.bag"));
}

}  // namespace
}  // namespace revisit_slam
