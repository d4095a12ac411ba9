// SPDX-License-Identifier: MIT
#include "revisit_slam/input/sweep_merger.h"

#include <gtest/gtest.h>

#include <cmath>

namespace revisit_slam {
namespace {

constexpr double kStart = 1000.001;  // s; windows begin at tenths, no point does

ScanInputConfig threeSensors() {
  ScanInputConfig config;
  config.topics = "/roof /front  /rear";
  return config;
}

/// A message of `seconds`, that began then; a point each 5 ms, whose x says when it was seen and
/// whose y by whom.
ScanReading messageOf(std::size_t sensor, double begin, double seconds = 0.1) {
  ScanReading reading;
  reading.sensor = sensor;
  reading.frame_id = "frame_" + std::to_string(sensor);
  Scan& scan = reading.scan.emplace();
  const int count = static_cast<int>(std::lround(seconds / 0.005));
  const double last = 0.005 * (count - 1);
  scan.stamp = Stamp::fromSeconds(kStart + begin + last);
  scan.T_base_sensor.translation.x() = static_cast<double>(sensor);
  for (int i = 0; i < count; ++i) {
    scan.points.emplace_back(static_cast<float>(begin + 0.005 * i), static_cast<float>(sensor),
                             1.0f);
    scan.times.push_back(static_cast<float>(0.005 * i - last));
  }
  return reading;
}

using Sweeps = std::vector<ScanReading>;

void append(Sweeps more, Sweeps& sweeps) {
  for (ScanReading& sweep : more) sweeps.push_back(std::move(sweep));
}

/// In the order in which messages end; the roof at 10 Hz, the front at 20 Hz, the rear at 5 Hz.
Sweeps play(SweepMerger& merger, double seconds, double lost_from = 1e9, double lost_until = 1e9) {
  Sweeps sweeps;
  for (int i = 0; i < static_cast<int>(seconds / 0.05); ++i) {
    const double now = 0.05 * i;
    append(merger.take(messageOf(1, now, 0.05)), sweeps);
    if (i % 2 == 1) append(merger.take(messageOf(0, now - 0.05)), sweeps);
    const bool is_lost = lost_from <= now && now < lost_until;
    if (i % 4 == 3 && !is_lost) append(merger.take(messageOf(2, now - 0.15, 0.2)), sweeps);
  }
  return sweeps;
}

/// So many messages of 0.1 s of each sensor, one sensor after the other. `begin`: s, of the i-th of
/// a sensor.
template <typename Begin>
Sweeps inTurn(SweepMerger& merger, int count, const Begin& begin,
              const std::vector<std::size_t>& sensors = {0, 1, 2}) {
  Sweeps sweeps;
  for (int i = 0; i < count; ++i)
    for (const std::size_t sensor : sensors)
      append(merger.take(messageOf(sensor, begin(i, sensor))), sweeps);
  return sweeps;
}

double tenthsFrom0(int i, std::size_t) {
  return 0.1 * i;
}

std::size_t pointsOf(const Sweeps& sweeps, std::size_t sensor) {
  std::size_t count = 0;
  for (const ScanReading& sweep : sweeps)
    for (const Eigen::Vector3f& point : sweep.scan->points)
      count += point.y() == static_cast<float>(sensor);
  return count;
}

TEST(SweepMerger, EachSweepHoldsWhatAllSawInItsTime) {
  SweepMerger merger(threeSensors());
  const Sweeps sweeps = play(merger, 2.0);
  ASSERT_GE(sweeps.size(), 18u);
  for (const ScanReading& sweep : sweeps) {
    const Scan& scan = *sweep.scan;
    ASSERT_EQ(scan.views.size(), 3u);
    ASSERT_EQ(scan.times.size(), scan.points.size());
    EXPECT_EQ(scan.points.size(), 60u);
    const double begin = std::floor(10.0 * scan.stamp.toSeconds()) / 10.0 - kStart;
    std::size_t i = 0;
    for (std::size_t view = 0; view < 3; ++view) {
      EXPECT_EQ(scan.views[view].T_base_sensor.translation.x(), static_cast<double>(view));
      for (; i < scan.views[view].end; ++i) {
        EXPECT_EQ(scan.points[i].y(), static_cast<float>(view));
        const double seen = scan.points[i].x();
        EXPECT_NEAR(scan.stamp.toSeconds() + static_cast<double>(scan.times[i]) - kStart, seen,
                    1e-4);
        EXPECT_GT(seen, begin - 1e-3);
        EXPECT_LT(seen, begin + 0.1 + 1e-3);
      }
    }
    EXPECT_EQ(i, scan.points.size());
    for (const float time : scan.times) EXPECT_LE(time, 0.0f);
  }
}

/// Whoever comes first.
TEST(SweepMerger, TheOrderInWhichTopicsArriveChangesNothing) {
  SweepMerger one(threeSensors()), other(threeSensors());
  const Sweeps a = inTurn(one, 10, tenthsFrom0), b = inTurn(other, 10, tenthsFrom0, {2, 0, 1});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].scan->stamp, b[i].scan->stamp);
    EXPECT_EQ(a[i].scan->points, b[i].scan->points);
    EXPECT_EQ(a[i].scan->times, b[i].scan->times);
  }
}

TEST(SweepMerger, ASensorThatIsLostCostsNoneOfTheOthersAndComesBack) {
  SweepMerger merger(threeSensors());
  const Sweeps sweeps = play(merger, 10.0, 3.0, 7.0);
  EXPECT_GE(sweeps.size(), 97u);
  EXPECT_GE(pointsOf(sweeps, 0), 97u * 20u);
  EXPECT_GE(pointsOf(sweeps, 1), 97u * 20u);
  const auto rear = static_cast<double>(pointsOf(sweeps, 2));
  EXPECT_NEAR(rear, 0.6 * 98.0 * 20.0, 60.0);
  EXPECT_FALSE(merger.accounts().at("/rear").is_silent);
  SweepMerger lost(threeSensors());
  play(lost, 5.0, 3.0);
  EXPECT_TRUE(lost.accounts().at("/rear").is_silent);
}

/// Those of the rear, at 10 Hz, come 0.08 s after they end, just in time for their sweeps.
TEST(SweepMerger, ASensorWhoseMessagesTakeTheirTimeComesBackToo) {
  ScanInputConfig config = threeSensors();
  config.topics = "/front /rear";
  SweepMerger merger(config);
  Sweeps sweeps;
  for (int i = 0; i < 100; ++i) {
    const double now = 0.1 * i;
    append(merger.take(messageOf(0, now)), sweeps);  // ends at now + 0.1
    const bool is_lost = 30 <= i && i < 60;
    if (i > 0 && !is_lost) append(merger.take(messageOf(1, now - 0.08)), sweeps);
    if (i < 40 || i >= 45) {  // it is called so after little more than a second
      EXPECT_EQ(merger.accounts().at("/rear").is_silent, 45 <= i && i < 60) << i;
    }
  }
  EXPECT_FALSE(merger.accounts().at("/rear").is_silent);
  EXPECT_FALSE(merger.accounts().at("/rear").is_late);
  EXPECT_NEAR(static_cast<double>(pointsOf(sweeps, 1)), 68.0 * 20.0, 60.0);
}

TEST(SweepMerger, ASensorWithAnotherClockCostsItselfAlone) {
  for (const double off : {37.0, -37.0}) {
    for (const std::size_t other :
         {std::size_t{0}, std::size_t{2}}) {  // the first to send, and not
      SweepMerger merger(threeSensors());
      const Sweeps sweeps = inTurn(merger, 40, [&](int i, std::size_t sensor) {
        return 0.1 * i + (sensor == other ? off : 0.0);
      });
      EXPECT_GE(pointsOf(sweeps, 1), 36u * 20u);
      EXPECT_GE(pointsOf(sweeps, 2 - other), 36u * 20u);
      const SensorAccount account = merger.accounts().at(other == 0 ? "/roof" : "/rear");
      EXPECT_TRUE(account.is_late);
      EXPECT_FALSE(account.is_silent);
      EXPECT_NEAR(account.behind, -off, 0.11);
      EXPECT_GE(account.points_dropped.at("of another clock"), 36u * 20u);
      EXPECT_FALSE(merger.accounts().at("/front").is_late);
    }
  }
}

TEST(SweepMerger, AClockThatStepsWhileItDrivesCostsItsSensorUntilItIsRight) {
  SweepMerger merger(threeSensors());
  const Sweeps sweeps = inTurn(merger, 90, [](int i, std::size_t sensor) {
    const bool is_off = sensor == 0 && 30 <= i && i < 60;
    return 0.1 * i + (is_off ? 18.0 : 0.0);
  });
  EXPECT_GE(pointsOf(sweeps, 1), 85u * 20u);
  EXPECT_GE(pointsOf(sweeps, 2), 85u * 20u);
  EXPECT_NEAR(static_cast<double>(pointsOf(sweeps, 0)), 59.0 * 20.0, 80.0);
  EXPECT_FALSE(merger.accounts().at("/roof").is_late);
}

TEST(SweepMerger, OfTwoClocksThatOfTheFirstIsTaken) {
  ScanInputConfig config = threeSensors();
  config.topics = "/a /b";
  SweepMerger merger(config);
  const Sweeps sweeps =
      inTurn(merger, 40,
             [](int i, std::size_t sensor) { return 0.1 * i + 5.0 * static_cast<double>(sensor); },
             {0, 1});
  EXPECT_GE(pointsOf(sweeps, 0), 38u * 20u);
  EXPECT_TRUE(merger.accounts().at("/b").is_late);
}

/// Whichever goes on first; before, the first was the clock.
TEST(SweepMerger, APauseOfAllCostsNothing) {
  SweepMerger merger(threeSensors());
  inTurn(merger, 20, tenthsFrom0);
  inTurn(merger, 20, [](int i, std::size_t) { return 13.0 + 0.1 * i; }, {1, 2, 0});
  for (const auto& [topic, account] : merger.accounts())
    EXPECT_EQ(account.points_dropped.count("of another clock"), 0u) << topic;
}

/// The last message before a pause, which a flush ends, and the first of a sensor.
TEST(SweepMerger, AWrongStampThatNothingConfirmsIsNotUsed) {
  SweepMerger merger(threeSensors());
  Sweeps sweeps = play(merger, 2.0);
  append(merger.take(messageOf(0, 3600.0)), sweeps);
  append(merger.flush(), sweeps);
  for (const ScanReading& sweep : sweeps) EXPECT_LT(sweep.scan->stamp.toSeconds(), kStart + 3.0);
  append(merger.take(messageOf(1, 2.0)), sweeps);
  EXPECT_EQ(merger.accounts().at("/front").points_dropped.count("too late"), 0u);

  SweepMerger begins(threeSensors());
  append(begins.take(messageOf(0, 0.0)), sweeps);
  append(begins.take(messageOf(1, 3600.0)), sweeps);
  inTurn(begins, 20, [](int i, std::size_t) { return 0.1 * (i + 1); });
  for (const auto& [topic, account] : begins.accounts()) {
    EXPECT_FALSE(account.is_late) << topic;
    EXPECT_GE(account.points, 18u * 20u) << topic;
  }
}

TEST(SweepMerger, ASensorThatNeverComesIsNotWaitedForLong) {
  SweepMerger merger(threeSensors());
  Sweeps sweeps;
  for (int i = 0; i < 10; ++i) append(merger.take(messageOf(0, 0.1 * i)), sweeps);
  EXPECT_EQ(sweeps.size(), 9u);  // all but the one that is open
  EXPECT_EQ(merger.flush().size(), 1u);
  EXPECT_TRUE(merger.accounts().at("/front").is_silent);
}

TEST(SweepMerger, RangesAndClocksAreThoseOfEachSensor) {
  ScanInputConfig config = threeSensors();
  config.topics = "/a /b";
  config.ranges = "0 100 2 100";
  config.time_offsets = "0 -0.5";
  SweepMerger merger(config);
  Sweeps sweeps;
  for (int i = 0; i < 10; ++i) {
    ScanReading other = messageOf(1, 0.1 * i);
    other.scan->stamp = other.scan->stamp.plusSeconds(0.5);
    append(merger.take(messageOf(0, 0.1 * i)), sweeps);
    append(merger.take(other), sweeps);
  }
  ASSERT_GE(sweeps.size(), 8u);
  EXPECT_EQ(pointsOf(sweeps, 1), 0u);  // within 2 m
  EXPECT_EQ(merger.accounts().at("/b").points_dropped.at("too near"), 200u);
  for (const ScanReading& sweep : sweeps) EXPECT_EQ(sweep.scan->views.size(), 1u);
}

TEST(SweepMerger, AWrongStampAheadCostsItsMessageAlone) {
  SweepMerger merger(threeSensors());
  Sweeps sweeps = play(merger, 2.0);
  append(merger.take(messageOf(0, 3600.0)), sweeps);
  append(inTurn(merger, 20, [](int i, std::size_t) { return 0.1 * (i + 20); }), sweeps);
  EXPECT_GE(sweeps.size(), 37u);
  EXPECT_EQ(merger.accounts().at("/roof").points_dropped.at("stamp ahead of the next one"), 20u);
}

TEST(SweepMerger, AClockThatWasSetBackGoesOn) {
  SweepMerger merger(threeSensors());
  const std::size_t before = play(merger, 20.0).size();
  const Sweeps after = play(merger, 2.0);
  EXPECT_GE(before, 195u);
  EXPECT_GE(after.size(), 18u);
  EXPECT_LT(after.back().scan->stamp.toSeconds(), kStart + 2.0);
}

TEST(SweepMerger, ListsOfAnotherNumberOfSensorsAreRefused) {
  ScanInputConfig config = threeSensors();
  config.ranges = "0 100 2 100";
  EXPECT_THROW(SweepMerger{config}, ParameterError);
  config.ranges.clear();
  config.time_offsets = "0 x 1";
  EXPECT_THROW(SweepMerger{config}, ParameterError);
  config.time_offsets = "0 1e300 1";
  EXPECT_THROW(SweepMerger{config}, ParameterError);
}

TEST(SweepMerger, SweepsOfNoLengthAreRefused) {
  ScanInputConfig config = threeSensors();
  config.scan_period = 1e-10;
  EXPECT_THROW(SweepMerger{config}, ParameterError);
}

TEST(SweepMerger, EveryPointIsInASweepOrDropped) {
  SweepMerger merger(threeSensors());
  Sweeps sweeps;
  for (int i = 0; i < 10; ++i)  // the first window has but its end
    for (const std::size_t sensor : {0, 1, 2})
      append(merger.take(messageOf(sensor, 0.07 + 0.1 * i)), sweeps);
  append(merger.flush(), sweeps);
  std::size_t in_sweeps = 0, dropped = 0;
  for (const auto& [topic, account] : merger.accounts()) {
    in_sweeps += account.points;
    for (const auto& [reason, points] : account.points_dropped) dropped += points;
  }
  std::size_t handed_on = 0;
  for (const ScanReading& sweep : sweeps) handed_on += sweep.scan->points.size();
  EXPECT_EQ(in_sweeps, handed_on);
  EXPECT_GT(dropped, 0u);
}

TEST(SweepMerger, PointsKeepTheirIntensities) {
  SweepMerger merger(threeSensors());
  Sweeps sweeps;
  for (int i = 0; i < 10; ++i) {
    for (const std::size_t sensor : {0, 1, 2}) {
      ScanReading message = messageOf(sensor, 0.1 * i);
      if (sensor != 1)
        message.scan->intensities.assign(message.scan->points.size(),
                                         10.0f * static_cast<float>(sensor + 1));
      append(merger.take(std::move(message)), sweeps);
    }
  }
  ASSERT_GT(sweeps.size(), 5u);
  const Scan& scan = *sweeps[3].scan;
  ASSERT_EQ(scan.intensities.size(), scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    EXPECT_EQ(scan.intensities[i],
              scan.points[i].y() == 1.0f ? 0.0f : 10 * (scan.points[i].y() + 1));
}

TEST(SweepMerger, OneSensorIsNotMerged) {
  EXPECT_FALSE(SweepMerger(ScanInputConfig()).merges());
  EXPECT_TRUE(SweepMerger(ScanInputConfig()).accounts().empty());
}

}  // namespace
}  // namespace revisit_slam
