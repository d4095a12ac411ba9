// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/input_watch.h"

#include <gtest/gtest.h>

#include "support/contains.h"

namespace revisit_slam {
namespace {

using Level = InputWatch::Level;
using Fault = InputWatch::Fault;

const TypedTopic kVelodyne{"/velodyne_points", "sensor_msgs/PointCloud2"};

/// A node that listens to /points, and is looked at once a second.
class Watched : public testing::Test {
 protected:
  Watched() { state_.topics = {"/points"}; }

  InputWatch::Verdict lookAfter(double seconds, std::size_t scans, std::size_t processed) {
    state_.now += seconds;
    state_.arrived += scans;
    state_.account.received += scans;
    state_.account.processed += processed;
    return watch_.look(state_);
  }
  void run(int seconds) {
    for (int i = 0; i < seconds; ++i) ASSERT_EQ(lookAfter(1.0, 10, 10).level, Level::ok);
  }
  void expect(const InputWatch::Verdict& verdict, Level level, Fault fault,
              const std::string& remedy) const {
    EXPECT_EQ(verdict.level, level) << verdict.sentence;
    EXPECT_EQ(verdict.fault, fault) << verdict.sentence;
    EXPECT_TRUE(contains(verdict.sentence, remedy)) << verdict.sentence;
  }

  InputWatch watch_;
  InputState state_;
};

TEST_F(Watched, ScansThatComeAndAreUsedAreFineAndTheirRateIsSaid) {
  run(6);
  EXPECT_EQ(lookAfter(1.0, 10, 10).sentence, "10.0 scans/s on /points");
  EXPECT_FALSE(watch_.isSilent(state_.now, state_.arrived));
}

TEST_F(Watched, ATopicThatNobodyPublishesIsSaidWithThoseThatThereAre) {
  EXPECT_EQ(lookAfter(1.0, 0, 0).sentence, "no scan yet on /points");
  state_.published = {kVelodyne};
  EXPECT_FALSE(watch_.isSilent(state_.now + 2.0, 0));
  EXPECT_TRUE(watch_.isSilent(state_.now + 4.0, 0));
  const auto verdict = lookAfter(4.0, 0, 0);
  EXPECT_TRUE(verdict.is_new);
  expect(verdict, Level::warn, Fault::nothing_comes,
         "no scan in 4 s: nobody publishes /points: start with points:=/velodyne_points");
  EXPECT_FALSE(lookAfter(1.0, 0, 0).is_new);
}

TEST_F(Watched, ADriverThatStopsIsSaidWithTheTimeSinceAndTheRateBefore) {
  run(10);
  lookAfter(1.0, 0, 0);
  lookAfter(1.0, 0, 0);
  EXPECT_TRUE(watch_.isSilent(state_.now + 1.0, state_.arrived));
  state_.published = {{"/points", "sensor_msgs/PointCloud2"}};
  const auto verdict = lookAfter(1.0, 0, 0);
  expect(verdict, Level::warn, Fault::stopped, "no scan for 3 s (before: 10.0 scans/s)");
  expect(verdict, Level::warn, Fault::stopped, "rostopic hz /points");
  EXPECT_EQ(lookAfter(1.0, 10, 10).fault, Fault::none);
}

TEST_F(Watched, ASlowSensorIsNotSilentBetweenTwoScans) {
  for (int i = 0; i < 10; ++i) EXPECT_EQ(lookAfter(2.0, 1, 1).level, Level::ok);
  EXPECT_FALSE(watch_.isSilent(state_.now + 4.0, state_.arrived));
  EXPECT_TRUE(watch_.isSilent(state_.now + 21.0, state_.arrived));
}

TEST_F(Watched, AMissingTransformIsAnErrorAndNotAnOverload) {
  lookAfter(1.0, 10, 0);
  state_.transform_fault = "TF has no transform";
  state_.waiting = 99;
  state_.account.dropped["queue full"] = 7;
  expect(lookAfter(1.0, 10, 0), Level::error, Fault::transform,
         "100 scans wait: TF has no transform");
  expect(lookAfter(1.0, 10, 10), Level::warn, Fault::transform,
         "some messages are dropped: TF has no transform");
}

TEST_F(Watched, ScansThatAreAllDroppedAreAnErrorWithTheRemedy) {
  run(2);
  state_.account.dropped["no stamp"] = 10;
  expect(lookAfter(1.0, 10, 0), Level::error, Fault::all_dropped, "10 of late: no stamp: ");
  state_.account.dropped["no stamp"] = 20;
  expect(lookAfter(1.0, 10, 0), Level::error, Fault::all_dropped, "set input/stamps to arrival");
}

TEST_F(Watched, SomeScansThatAreDroppedAreAWarningThatIsNotLoggedAgain) {
  run(2);
  state_.account.dropped["duplicate stamp"] = 1;
  const auto verdict = lookAfter(1.0, 10, 9);
  expect(verdict, Level::warn, Fault::some_dropped, "1 of late: duplicate stamp: ");
  EXPECT_FALSE(verdict.is_new);
  EXPECT_EQ(lookAfter(1.0, 10, 10).level, Level::ok);
}

TEST_F(Watched, AnOverloadIsSaidWithItsNumbersAndItsCause) {
  run(10);
  state_.scan_seconds = 0.16;
  state_.account.dropped["queue full"] = 3;
  expect(lookAfter(1.0, 10, 7), Level::warn, Fault::overload,
         "scans come every 100 ms and take 160 ms each: give it more threads (odometry/threads)");
  state_.scan_seconds = 0.01;
  state_.account.dropped["queue full"] = 6;
  expect(lookAfter(1.0, 10, 7), Level::warn, Fault::overload,
         "the machine was busy with something else");
}

TEST_F(Watched, ScansWithoutPointTimesAreAWarning) {
  state_.time_fault = "deskewing off: no time field; set input/time_field";
  expect(lookAfter(1.0, 10, 10), Level::warn, Fault::no_times, state_.time_fault);
}

TEST_F(Watched, AClockThatDoesNotRunIsSaidWithBothRemedies) {
  state_.clock_runs = false;
  EXPECT_EQ(lookAfter(1.0, 0, 0).level, Level::ok);
  expect(lookAfter(4.0, 0, 0), Level::warn, Fault::clock, "rosbag play --clock");
  expect(lookAfter(1.0, 0, 0), Level::warn, Fault::clock, "rosparam set /use_sim_time false");
}

TEST_F(Watched, ANewSessionCountsItsDropsFromZero) {
  state_.account.dropped["no points"] = 5;
  lookAfter(1.0, 10, 10);
  state_.account = {};
  state_.account.dropped["no points"] = 2;
  expect(lookAfter(1.0, 10, 8), Level::warn, Fault::some_dropped, "2 of late: no points");
}

}  // namespace
}  // namespace revisit_slam
