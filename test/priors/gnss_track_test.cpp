// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/gnss_track.h"

#include <gtest/gtest.h>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

constexpr double kStart = 100.0;  // s
const Eigen::Vector3d kAntenna(0.5, 0.0, 2.0);

GnssConfig connected() {
  GnssConfig config;
  config.topic = "/fix";
  config.spacing = 0.0;
  return config;
}

/// 10 m/s, a scan each 0.1 s, turning.
Pose poseAt(double seconds) {
  return {expSO3({0.0, 0.0, 0.1 * seconds}), {10.0 * seconds, 0.0, 0.0}};
}

GnssReading readingAt(double seconds) {
  GnssReading reading;
  reading.stamp = Stamp::fromSeconds(kStart + seconds);
  reading.position = {48.0, 11.0, 500.0};
  reading.p_base = kAntenna;
  return reading;
}

/// Scans from `from` on up to `to`, and what is due with them.
std::vector<GnssFix> drive(GnssTrack& track, std::uint32_t from, std::uint32_t to) {
  std::vector<GnssFix> fixes;
  for (std::uint32_t i = from; i < to; ++i) {
    track.observe(ScanId{i}, Stamp::fromSeconds(kStart + 0.1 * i), poseAt(0.1 * i));
    for (const GnssFix& fix : track.due()) fixes.push_back(fix);
  }
  return fixes;
}

TEST(GnssTrack, APositionIsTiedToTheScanBeforeItAlongTheOdometry) {
  GnssTrack track(connected());
  track.take(readingAt(0.234));
  EXPECT_TRUE(drive(track, 0, 12).empty()) << "before max_delay is over";
  const std::vector<GnssFix> fixes = drive(track, 12, 14);
  ASSERT_EQ(fixes.size(), 1u);
  EXPECT_EQ(fixes[0].scan, ScanId{2});
  const Eigen::Vector3d p_odom = poseAt(0.2) * fixes[0].p_scan;
  EXPECT_LT((p_odom - poseAt(0.234) * kAntenna).norm(), 2e-3);  // a chord of the bend
  EXPECT_EQ(track.account().used, 1u);
}

TEST(GnssTrack, OfACovarianceThatIsNoneTheVariancesAreTaken) {
  GnssTrack track(connected());
  GnssReading reading = readingAt(0.2);
  reading.covariance_enu.setConstant(9.0);
  track.take(reading);
  const std::vector<GnssFix> fixes = drive(track, 0, 14);
  ASSERT_EQ(fixes.size(), 1u);
  EXPECT_EQ(fixes[0].covariance_enu, Eigen::Matrix3d(9.0 * Eigen::Matrix3d::Identity()));
}

TEST(GnssTrack, WhenAMessageComesWithinTheDelayMakesNoDifference) {
  GnssTrack early(connected()), late(connected());
  early.take(readingAt(0.5));
  early.take(readingAt(0.7));
  drive(early, 0, 14);
  drive(late, 0, 14);
  late.take(readingAt(0.7));
  late.take(readingAt(0.5));
  const std::vector<GnssFix> a = drive(early, 14, 30), b = drive(late, 14, 30);
  ASSERT_EQ(a.size(), 2u);
  ASSERT_EQ(b.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(a[i].stamp, b[i].stamp);
    EXPECT_EQ(a[i].p_scan, b[i].p_scan);
  }
}

TEST(GnssTrack, WhatCannotBeTiedIsDroppedAndCounted) {
  GnssTrack track(connected());
  track.take(readingAt(-0.5));
  track.take(readingAt(0.55));
  track.take(readingAt(0.55));
  drive(track, 0, 30);
  track.take(readingAt(1.0));
  track.take(readingAt(4.0));
  track.observe(ScanId{30}, Stamp::fromSeconds(kStart + 6.0), poseAt(6.0));
  EXPECT_TRUE(track.due().empty());
  const auto& dropped = track.account().dropped;
  EXPECT_EQ(dropped.at("before the first scan"), 1u);
  EXPECT_EQ(dropped.at("duplicate stamp"), 1u);
  EXPECT_EQ(dropped.at("too late"), 1u);
  EXPECT_EQ(dropped.at("scans are missing around it"), 1u);
  EXPECT_EQ(track.account().received, 5u);
  EXPECT_EQ(track.account().used, 1u);
}

TEST(GnssTrack, TheStampsAreMovedByTheTimeOffset) {
  GnssConfig config = connected();
  config.time_offset = -0.2;
  GnssTrack track(config);
  track.take(readingAt(0.55));
  const std::vector<GnssFix> fixes = drive(track, 0, 20);
  ASSERT_EQ(fixes.size(), 1u);
  EXPECT_EQ(fixes[0].scan, ScanId{3});
}

TEST(GnssTrack, PositionsNearTheOneBeforeAreLeftOut) {
  GnssConfig config = connected();
  config.spacing = 5.0;  // half a second
  GnssTrack track(config);
  for (int i = 0; i < 20; ++i) track.take(readingAt(0.1 * i));
  EXPECT_EQ(drive(track, 0, 40).size(), 4u);
  EXPECT_EQ(track.account().dropped.at("nearer than gnss/spacing"), 16u);
}

/// A receiver that finds its phase.
TEST(GnssTrack, APositionThatIsMuchBetterThanTheOneNearItIsUsed) {
  GnssConfig config = connected();
  config.spacing = 5.0;
  GnssTrack track(config);
  for (int i = 0; i < 4; ++i) {
    GnssReading reading = readingAt(0.1 * i);
    reading.covariance_enu *= i < 2 ? 2500.0 : 0.01;
    track.take(reading);
  }
  const std::vector<GnssFix> fixes = drive(track, 0, 40);
  ASSERT_EQ(fixes.size(), 2u);
  EXPECT_EQ(fixes[1].stamp, readingAt(0.2).stamp);
}

/// At rest ids repeat: the node of the graph is where the first of them was.
TEST(GnssTrack, ABaseAtRestIsTheNodeOfItsFirstScan) {
  GnssTrack track(connected());
  track.take(readingAt(0.25));
  for (int i = 0; i < 20; ++i)
    track.observe(ScanId{0}, Stamp::fromSeconds(kStart + 0.1 * i), poseAt(0.001 * i));
  const std::vector<GnssFix> fixes = track.due();
  ASSERT_EQ(fixes.size(), 1u);
  EXPECT_LT((fixes[0].p_scan - poseAt(0.0025) * kAntenna).norm(), 1e-6);
}

TEST(GnssTrack, NoPositionIsSurerThanTheSmallestDeviation) {
  GnssTrack track(connected());
  GnssReading reading = readingAt(0.2);
  reading.covariance_enu *= 1e-8;
  track.take(reading);
  const std::vector<GnssFix> fixes = drive(track, 0, 20);
  ASSERT_EQ(fixes.size(), 1u);
  EXPECT_NEAR(fixes[0].covariance_enu(0, 0), 0.01, 1e-9);
}

TEST(GnssTrack, AReceiverWithoutPositionsIsSilent) {
  GnssTrack track(connected());
  drive(track, 0, 90);
  EXPECT_FALSE(track.account().is_silent);
  track.countDropped("no fix");
  drive(track, 90, 120);
  EXPECT_TRUE(track.account().is_silent);
  track.take(readingAt(12.0));
  drive(track, 120, 130);
  EXPECT_FALSE(track.account().is_silent);
  drive(track, 130, 240);
  EXPECT_TRUE(track.account().is_silent);
}

TEST(GnssTrack, AnotherSessionBeginsAnew) {
  GnssTrack track(connected());
  track.take(readingAt(0.25));
  drive(track, 0, 3);
  track.restart();
  EXPECT_EQ(track.account().received, 0u);
  EXPECT_TRUE(drive(track, 0, 30).empty());
}

}  // namespace
}  // namespace revisit_slam
