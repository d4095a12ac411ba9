// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/scan_examination.h"

#include <gtest/gtest.h>

#include "revisit_slam/ros/messages/pose_conversions.h"
#include "support/contains.h"
#include "support/raw_messages.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

using Level = Finding::Level;

/// As they come from a driver, `late` seconds after their stamp.
std::vector<Finding> examine(const std::vector<sensor_msgs::PointCloud2>& clouds,
                             double late = 0.01, const SlamConfig& config = {}) {
  ScanExamination examination(config);
  Stamp arrival{1'700'000'000'000'000'000};
  for (const sensor_msgs::PointCloud2& cloud : clouds) {
    RawMessage raw{"sensor_msgs/PointCloud2",
                   ros::message_traits::md5sum<sensor_msgs::PointCloud2>(), "", bytesOf(cloud),
                   arrival.plusSeconds(late)};
    examination.add(raw);
    arrival = arrival.plusSeconds(0.1);
  }
  return examination.findings();
}

Finding about(const std::string& part, const std::vector<Finding>& findings) {
  for (const Finding& finding : findings)
    if (finding.part == part) return finding;
  return {Level::fault, "no finding about " + part, "", ""};
}

TEST(ScanExamination, FindsNothingWrongWithAGoodDrive) {
  const std::vector<Finding> findings = examine(toClouds(driveInRoom(20)));
  EXPECT_EQ(findings.size(), 6u);
  for (const Finding& finding : findings)
    EXPECT_EQ(finding.level, Level::good) << finding.part << ": " << finding.text;
  EXPECT_EQ(about("rate", findings).text, "10.0 messages/s");
  EXPECT_TRUE(contains(about("point times", findings).text, "field 'time'"));
}

TEST(ScanExamination, NamesTheReasonForWhichScansWouldBeDropped) {
  auto clouds = toClouds(driveInRoom(10));
  for (auto& cloud : clouds) cloud.header.stamp = ros::Time();
  const Finding finding = about("messages", examine(clouds));
  EXPECT_EQ(finding.level, Level::fault);
  EXPECT_TRUE(contains(finding.text, "10 of 10 scans dropped, 10 of them for 'no stamp'"));
  EXPECT_TRUE(contains(finding.remedy, "set input/stamps to arrival"));
}

TEST(ScanExamination, ADuplicateStampIsFoundAsTheOdometryFindsIt) {
  auto clouds = toClouds(driveInRoom(10));
  clouds[5].header.stamp = clouds[4].header.stamp;
  const Finding finding = about("messages", examine(clouds));
  EXPECT_EQ(finding.level, Level::warning);
  EXPECT_TRUE(contains(finding.text, "'duplicate stamp'")) << finding.text;
}

TEST(ScanExamination, SaysThatTheSensorHasAnotherClock) {
  const Finding finding = about("header stamps", examine(toClouds(driveInRoom(5)), 3600.0));
  EXPECT_EQ(finding.level, Level::warning);
  EXPECT_TRUE(contains(finding.text, "3600.0 s before arrival"));
}

TEST(ScanExamination, SaysThatPointTimesAreMissing) {
  auto clouds = toClouds(driveInRoom(5));
  for (auto& cloud : clouds) cloud.fields.back().name = "intensity";
  const Finding finding = about("point times", examine(clouds));
  EXPECT_EQ(finding.level, Level::warning);
  EXPECT_TRUE(contains(finding.remedy, "input/time_field to azimuth"));
}

TEST(ScanExamination, SaysThatCoordinatesAreNotInMetres) {
  Drive drive = driveInRoom(5);
  for (Scan& scan : drive.scans)
    for (Eigen::Vector3f& p : scan.points) p *= 1000.f;
  const Finding finding = about("ranges", examine(toClouds(drive)));
  EXPECT_EQ(finding.level, Level::fault);
  EXPECT_TRUE(contains(finding.remedy, "must be in metres"));
}

TEST(ScanExamination, SaysThatMessagesAreMissing) {
  ScanExamination examination{SlamConfig()};
  const auto clouds = toClouds(driveInRoom(20));
  for (std::size_t i = 0; i < clouds.size(); ++i)
    if (i < 5 || i > 14)
      examination.add({"sensor_msgs/PointCloud2",
                       ros::message_traits::md5sum<sensor_msgs::PointCloud2>(), "",
                       bytesOf(clouds[i]), toStamp(clouds[i].header.stamp)});
  const Finding finding = about("rate", examination.findings());
  EXPECT_EQ(finding.level, Level::warning);
  EXPECT_TRUE(contains(finding.text, "the longest pause is 1.1 s")) << finding.text;
}

}  // namespace
}  // namespace revisit_slam
