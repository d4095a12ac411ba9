// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/gravity_track.h"

#include <gtest/gtest.h>

#include <cmath>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

constexpr double kGravity = 9.81;
const Eigen::Vector3d kUnit(0.8, 0.3, -0.4);  // in the base frame

/// Brakes, speeds up and sways through bends and over humps; which way the odometry's z axis points
/// is not up.
Pose poseAt(double seconds) {
  const Eigen::Vector3d turn(0.05 * std::sin(0.9 * seconds), 0.08 * std::sin(0.7 * seconds),
                             0.4 * seconds);
  return Pose{expSO3({0.1, -0.2, 0.0}), Eigen::Vector3d::Zero()} *
         Pose{expSO3({0.0, 0.0, turn.z()}) * expSO3({turn.x(), turn.y(), 0.0}),
              {10.0 * seconds + 3.0 * std::sin(0.8 * seconds), 5.0 * std::sin(0.4 * seconds),
               0.5 * std::sin(0.7 * seconds)}};
}

Eigen::Vector3d upInOdom() {
  return Pose{expSO3({0.1, -0.2, 0.0}), Eigen::Vector3d::Zero()} * Eigen::Vector3d::UnitZ();
}

ImuReading readingAt(double seconds) {
  constexpr double h = 1e-3;
  const auto unitAt = [](double t) -> Eigen::Vector3d { return poseAt(t) * kUnit; };
  ImuReading reading;
  reading.stamp = Stamp::fromSeconds(100.0 + seconds);
  reading.p_base = kUnit;
  const Eigen::Vector3d acceleration =
      (unitAt(seconds + h) - 2.0 * unitAt(seconds) + unitAt(seconds - h)) / (h * h);
  reading.acceleration =
      poseAt(seconds).rotation.conjugate() * (acceleration + kGravity * upInOdom());
  return reading;
}

struct Result {
  std::vector<GravityDirection> directions;
  PriorAccount account;
};

/// Scans at 10 Hz, readings at 100 Hz.
Result drive(double seconds, const GravityConfig& config = {}, double rate = 100.0) {
  GravityTrack track(config);
  Result result;
  int read = 0;
  for (int scan = 0; scan < static_cast<int>(10 * seconds); ++scan) {
    const double now = 0.1 * scan;
    for (; read / rate <= now + 1e-9; ++read) track.take(readingAt(read / rate));
    const auto direction = track.observe(ScanId{static_cast<std::uint32_t>(scan)},
                                         Stamp::fromSeconds(100.0 + now), poseAt(now));
    if (direction) result.directions.push_back(*direction);
  }
  result.account = track.account();
  return result;
}

TEST(GravityTrack, FindsUpWhateverTheBaseDoes) {
  const Result result = drive(41.0);
  ASSERT_EQ(result.directions.size(), 10u);
  for (const GravityDirection& direction : result.directions) {
    const Pose T_odom_base = poseAt(0.1 * direction.scan.value);
    const Eigen::Vector3d up_odom = T_odom_base.rotation * direction.up_base;
    EXPECT_LT((up_odom - upInOdom()).norm(), 5e-4) << direction.scan.value;
  }
  EXPECT_EQ(result.account.used, 10u);
}

TEST(GravityTrack, GivesTheDirectionToTheScanInTheMiddle) {
  const Result result = drive(5.0);
  ASSERT_EQ(result.directions.size(), 1u);
  EXPECT_EQ(result.directions[0].scan.value, 20u);
}

TEST(GravityTrack, HasNoneWhereReadingsAreMissing) {
  const Result result = drive(9.0, {}, 2.0);
  EXPECT_TRUE(result.directions.empty());
  EXPECT_EQ(result.account.dropped.at("accelerations are missing"), 2u);
}

/// The mean of what is left would be that of another motion.
TEST(GravityTrack, HasNoneWhereTheUnitFellOutForAMoment) {
  GravityTrack track({});
  for (int i = 0; i <= 400; ++i)
    if (i < 150 || i > 200) track.take(readingAt(0.01 * i));
  for (int scan = 0; scan <= 40; ++scan)
    EXPECT_FALSE(track.observe(ScanId{static_cast<std::uint32_t>(scan)},
                               Stamp::fromSeconds(100.0 + 0.1 * scan), poseAt(0.1 * scan)));
  EXPECT_EQ(track.account().dropped.at("accelerations are missing"), 1u);
}

/// While it brakes, too: what was missed is as much as what was measured around it.
TEST(GravityTrack, AFewReadingsThatAreMissingDoNotTiltIt) {
  for (const int from : {100, 150, 200, 250}) {
    GravityTrack track({});
    for (int i = 0; i <= 400; ++i)
      if (i < from || i >= from + 23) track.take(readingAt(0.01 * i));
    for (int scan = 0; scan <= 40; ++scan) {
      const auto direction =
          track.observe(ScanId{static_cast<std::uint32_t>(scan)},
                        Stamp::fromSeconds(100.0 + 0.1 * scan), poseAt(0.1 * scan));
      if (!direction) continue;
      const Eigen::Vector3d up_odom =
          poseAt(0.1 * direction->scan.value).rotation * direction->up_base;
      EXPECT_LT((up_odom - upInOdom()).norm(), 1e-3) << from;
    }
    EXPECT_EQ(track.account().used, 1u);
  }
}

/// A vehicle that tilts while it is loaded has one id; the graph knows the scan that came first.
TEST(GravityTrack, AtRestTheDirectionIsInTheFrameOfTheScanThatTheGraphKnows) {
  GravityTrack track({});
  const auto poseOf = [](double seconds) {
    return Pose{expSO3({0.0, 0.01 * seconds, 0.0}), Eigen::Vector3d::Zero()};
  };
  std::optional<GravityDirection> direction;
  for (int scan = 0; scan <= 40; ++scan) {
    for (int i = 0; i < 10; ++i) {
      ImuReading reading;
      reading.stamp = Stamp::fromSeconds(100.0 + 0.1 * scan + 0.01 * i);
      reading.acceleration =
          poseOf(0.1 * scan + 0.01 * i).rotation.conjugate() * Eigen::Vector3d(0, 0, kGravity);
      track.take(reading);
    }
    if (const auto found =
            track.observe(ScanId{7}, Stamp::fromSeconds(100.0 + 0.1 * scan), poseOf(0.1 * scan)))
      direction = found;
  }
  ASSERT_TRUE(direction);
  EXPECT_LT((direction->up_base - Eigen::Vector3d::UnitZ()).norm(), 1e-3);
}

TEST(GravityTrack, SaysWhereScansAreTooFarApart) {
  GravityTrack track({});
  for (int i = 0; i <= 400; ++i) track.take(readingAt(0.01 * i));
  for (int scan = 0; scan <= 4; ++scan)
    track.observe(ScanId{static_cast<std::uint32_t>(scan)}, Stamp::fromSeconds(100.0 + scan),
                  poseAt(scan));
  EXPECT_EQ(track.account().dropped.at("scans are missing"), 4u);
}

TEST(GravityTrack, HasNoneOfAUnitThatMeasuresSomethingElse) {
  GravityTrack track({});
  for (int i = 0; i <= 400; ++i) {
    ImuReading reading = readingAt(0.01 * i);
    *reading.acceleration *= 1.0 / kGravity;  // in g
    track.take(reading);
  }
  for (int scan = 0; scan <= 40; ++scan)
    EXPECT_FALSE(track.observe(ScanId{static_cast<std::uint32_t>(scan)},
                               Stamp::fromSeconds(100.0 + 0.1 * scan), poseAt(0.1 * scan)));
  EXPECT_EQ(track.account().dropped.at("not of the size of gravity"), 1u);
}

TEST(GravityTrack, IsOffWhereItIsDisabled) {
  GravityConfig config;
  config.enabled = false;
  EXPECT_TRUE(drive(9.0, config).directions.empty());
}

/// Across a gap nothing is known of the motion between.
TEST(GravityTrack, BeginsAnewAfterAGapOfScans) {
  GravityTrack track({});
  std::size_t directions = 0;
  for (int i = 0; i <= 1000; ++i) track.take(readingAt(0.01 * i));
  for (int scan = 0; scan <= 80; ++scan) {
    if (scan > 20 && scan < 30) continue;
    if (track.observe(ScanId{static_cast<std::uint32_t>(scan)},
                      Stamp::fromSeconds(100.0 + 0.1 * scan), poseAt(0.1 * scan)))
      ++directions;
  }
  EXPECT_EQ(directions, 1u);  // from 3 s to 7 s
}

TEST(GravityTrack, GoesOnAfterAClockThatWasSetBack) {
  GravityTrack track({});
  ImuReading of_another_day = readingAt(0.0);
  of_another_day.stamp = Stamp::fromSeconds(100'000.0);
  track.take(of_another_day);
  for (int i = 0; i <= 400; ++i) track.take(readingAt(0.01 * i));
  std::size_t directions = 0;
  for (int scan = 0; scan <= 40; ++scan)
    if (track.observe(ScanId{static_cast<std::uint32_t>(scan)},
                      Stamp::fromSeconds(100.0 + 0.1 * scan), poseAt(0.1 * scan)))
      ++directions;
  EXPECT_EQ(directions, 1u);
}

}  // namespace
}  // namespace revisit_slam
