// SPDX-License-Identifier: MIT
#include "revisit_slam/input/sweep_assembler.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/contains.h"
#include "support/sweep_parts.h"

namespace revisit_slam {
namespace {

using Sweeps = std::vector<SweepAssembler::Sweep>;

/// A sensor in a round hall.
struct Spinning {
  int beams = 16, columns = 900;
  double period = 0.1, first_azimuth = 180.0, view = 360.0;  // s, degrees
  bool clockwise = true;
  double stagger = 0.0;  // degrees by which beams differ in azimuth

  /// The one that ends at (index + 1) periods.
  Scan sweep(int index) const {
    Scan scan{Stamp{1'700'000'000'000'000'000}.plusSeconds((index + 1) * period), {}, {}, {}, {}};
    for (int column = 0; column < columns; ++column) {
      const double part = (column + 1.0) / columns;
      for (int beam = 0; beam < beams; ++beam) {
        const double turned = part * view + stagger * (beam % 4 - 1.5);
        const double azimuth = (first_azimuth + (clockwise ? -turned : turned)) * M_PI / 180.0;
        scan.points.emplace_back(10 * std::cos(azimuth), 10 * std::sin(azimuth), 0.2 * beam);
        scan.times.push_back(static_cast<float>((part - 1.0) * period));
      }
    }
    return scan;
  }

  std::vector<ScanReading> messages(int sweeps, std::size_t parts) const {
    std::vector<Scan> scans;
    for (int i = 0; i < sweeps; ++i) scans.push_back(sweep(i));
    return partsOf(scans, parts);
  }
};

Sweeps assemble(SweepAssembler& assembler, const std::vector<ScanReading>& messages) {
  Sweeps sweeps;
  for (const ScanReading& message : messages)
    for (SweepAssembler::Sweep& sweep : assembler.take(message)) sweeps.push_back(std::move(sweep));
  return sweeps;
}

void expectSameScan(const Scan& scan, const Scan& expected) {
  ASSERT_EQ(scan.points.size(), expected.points.size());
  EXPECT_NEAR(secondsBetween(scan.stamp, expected.stamp), 0.0, 1e-7);
  for (std::size_t i = 0; i < scan.points.size(); i += 77) {
    EXPECT_EQ(scan.points[i], expected.points[i]);
    EXPECT_NEAR(scan.times[i], expected.times[i], 1e-6);
  }
}

TEST(SweepAssembler, joinsPartsOfAnySizeOfAnySensor) {
  for (const std::size_t parts : {2u, 3u, 4u, 8u}) {
    for (const Spinning& sensor :
         {Spinning{}, Spinning{64, 600, 0.1, 0.0, 360.0, false}, Spinning{16, 900, 0.05},
          Spinning{32, 900, 0.1, 77.0, 360.0, true, 1.5}}) {
      SweepAssembler assembler({});
      const Sweeps sweeps = assemble(assembler, sensor.messages(12, parts));
      ASSERT_EQ(sweeps.size(), 12u) << parts;
      for (int i = 0; i < 12; ++i) {
        const SweepAssembler::Sweep& sweep = sweeps[static_cast<std::size_t>(i)];
        EXPECT_EQ(sweep.messages, parts);
        EXPECT_EQ(sweep.refusal, "");
        EXPECT_EQ(sweep.reading.counts.kept, sensor.sweep(i).points.size());
        expectSameScan(*sweep.reading.scan, sensor.sweep(i));
      }
      EXPECT_TRUE(contains(assembler.description(), "hold parts of sweeps"));
      EXPECT_EQ(assembler.held(), 0u);  // no sweep waits for the next message
    }
  }
}

TEST(SweepAssembler, joinsIntensitiesWithTheirPoints) {
  std::vector<ScanReading> messages = Spinning().messages(20, 3);
  for (std::size_t i = 0; i < messages.size(); ++i)
    if (i % 3 != 1)  // a part without any
      for (const Eigen::Vector3f& point : messages[i].scan->points)
        messages[i].scan->intensities.push_back(point.x());
  SweepAssembler assembler{ScanInputConfig()};
  std::size_t with = 0, joined = 0;
  for (const SweepAssembler::Sweep& sweep : assemble(assembler, messages)) {
    const Scan& scan = *sweep.reading.scan;
    ASSERT_EQ(scan.intensities.size(), scan.points.size());
    joined += sweep.messages > 1;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      EXPECT_TRUE(scan.intensities[i] == scan.points[i].x() || scan.intensities[i] == 0.0f);
      with += scan.intensities[i] != 0.0f;
    }
  }
  EXPECT_GT(joined, 5u);
  EXPECT_GT(with, 1000u);
}

TEST(SweepAssembler, joinsPacketsToRevolutions) {
  for (const double stagger : {0.0, 2.0}) {
    Spinning sensor;
    sensor.stagger = stagger;
    SweepAssembler assembler({});
    const Sweeps sweeps = assemble(assembler, sensor.messages(30, 75));
    EXPECT_NEAR(static_cast<double>(sweeps.size()), 30.0, 1.0);
    std::size_t points = 0;
    for (const SweepAssembler::Sweep& sweep : sweeps) {
      EXPECT_NEAR(static_cast<double>(sweep.messages), 75.0, 3.0);
      points += sweep.reading.scan->points.size();
    }
    for (const SweepAssembler::Sweep& sweep : assembler.flush())
      points += sweep.reading.scan->points.size();
    EXPECT_EQ(points, 30 * sensor.sweep(0).points.size());
  }
}

TEST(SweepAssembler, handsOnWholeSweepsAtOnceAndUnchanged) {
  SweepAssembler assembler({});
  for (int i = 0; i < 20; ++i) {
    const Scan sweep = Spinning{}.sweep(i);
    const Sweeps sweeps = assembler.take(partsOf(sweep, 1).front());
    ASSERT_EQ(sweeps.size(), 1u);
    EXPECT_EQ(sweeps[0].reading.scan->points, sweep.points);
    EXPECT_EQ(sweeps[0].messages, 1u);
  }
  EXPECT_EQ(assembler.description(), "");
}

TEST(SweepAssembler, revolutionsAreNotJoinedHoweverOftenTheyCome) {
  Spinning sensor;
  sensor.period = 0.02;
  SweepAssembler assembler({});
  EXPECT_EQ(assemble(assembler, sensor.messages(40, 1)).size(), 40u);
}

TEST(SweepAssembler, aFixedFieldOfViewIsASweepWhateverItsWidth) {
  for (const double view : {40.0, 120.0, 270.0}) {
    Spinning sensor;
    sensor.view = view;
    SweepAssembler assembler({});
    const Sweeps sweeps = assemble(assembler, sensor.messages(12, 1));
    ASSERT_EQ(sweeps.size(), 12u);
    for (const SweepAssembler::Sweep& sweep : sweeps) EXPECT_EQ(sweep.messages, 1u);
    EXPECT_EQ(assembler.description(), "");
  }
}

TEST(SweepAssembler, joinsFramesOfAFixedFieldOfViewThatComeTooOften) {
  for (const double period : {0.02, 0.01}) {
    Spinning sensor;
    sensor.view = 70.0;
    sensor.period = period;
    sensor.columns = 90;
    SweepAssembler assembler({});
    const Sweeps sweeps = assemble(assembler, sensor.messages(100, 1));
    const auto joined = static_cast<std::size_t>(std::lround(0.1 / period));
    ASSERT_EQ(sweeps.size(), 100 / joined);
    for (const SweepAssembler::Sweep& sweep : sweeps) EXPECT_EQ(sweep.messages, joined);
  }
}

TEST(SweepAssembler, aLostPartLeavesAHoleInItsSweepAlone) {
  for (const std::size_t lost : {40u, 41u}) {
    std::vector<ScanReading> messages = Spinning{}.messages(20, 3);
    messages.erase(messages.begin() + static_cast<std::ptrdiff_t>(lost));
    SweepAssembler assembler({});
    Sweeps sweeps = assemble(assembler, messages);
    ASSERT_EQ(sweeps.size(), 20u) << lost;
    for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(sweeps[i].messages, i == lost / 3 ? 2u : 3u);
    expectSameScan(*sweeps[15].reading.scan, Spinning{}.sweep(15));
  }
}

TEST(SweepAssembler, sweepsMayBeginAtAnyPart) {
  std::vector<ScanReading> messages = Spinning{}.messages(20, 3);
  messages.erase(messages.begin() + 30);
  SweepAssembler assembler({});
  for (const SweepAssembler::Sweep& sweep : assemble(assembler, messages))
    EXPECT_EQ(sweep.messages, 3u);
  EXPECT_EQ(assembler.held(), 2u);
}

TEST(SweepAssembler, revolutionsAcrossTwoMessagesWithEveryOtherOneLost) {
  const std::vector<ScanReading> all = Spinning{}.messages(20, 2);
  std::vector<ScanReading> messages;
  for (std::size_t i = 1; i + 1 < all.size(); i += 4) {
    messages.push_back(all[i]);
    messages.push_back(all[i + 1]);
  }
  SweepAssembler assembler({});
  const Sweeps sweeps = assemble(assembler, messages);
  ASSERT_EQ(sweeps.size(), 10u);
  for (const SweepAssembler::Sweep& sweep : sweeps) EXPECT_EQ(sweep.messages, 2u);
}

TEST(SweepAssembler, partsWithoutPointTimesHaveThoseOfTheirMessages) {
  std::vector<ScanReading> messages = Spinning{}.messages(12, 4);
  for (ScanReading& message : messages) message.scan->times.clear();
  SweepAssembler assembler({});
  const Sweeps sweeps = assemble(assembler, messages);
  ASSERT_EQ(sweeps.size(), 12u);
  for (const SweepAssembler::Sweep& sweep : sweeps) {
    EXPECT_EQ(sweep.messages, 4u);
    EXPECT_NEAR(sweep.reading.scan->times.front(), -0.075, 1e-6);
    EXPECT_EQ(sweep.reading.scan->times.back(), 0.f);
  }
}

TEST(SweepAssembler, refusesTimesByWhichMessagesOverlap) {
  SweepAssembler assembler({});
  std::vector<ScanReading> messages;
  for (int i = 0; i < 20; ++i) {
    Scan sweep = Spinning{}.sweep(i);
    messages.push_back(partsOf(sweep, 1).front());
    Scan& scan = *messages.back().scan;
    for (float& time : scan.times) time *= 3.f;
    scan.stamp = messages.back().header_stamp.plusSeconds(0.3);
  }
  const Sweeps sweeps = assemble(assembler, messages);
  ASSERT_EQ(sweeps.size(), 20u);
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const Scan& scan = *sweeps[i].reading.scan;
    EXPECT_TRUE(scan.times.empty());
    EXPECT_NEAR(secondsBetween(messages[i].header_stamp, scan.stamp), 0.1, 1e-3);
  }
  EXPECT_TRUE(contains(assembler.description(), "point times are not used, deskewing off"));
  EXPECT_TRUE(contains(assembler.description(), "input/time_unit"));
}

TEST(SweepAssembler, aBurstOfStampsChangesNothing) {
  std::vector<ScanReading> messages = Spinning{}.messages(20, 1);
  for (std::size_t i = 10; i < 14; ++i)
    messages[i].scan->stamp = messages[14].scan->stamp.plusSeconds(-1e-3 * (14.0 - i));
  SweepAssembler assembler({});
  for (const SweepAssembler::Sweep& sweep : assemble(assembler, messages))
    EXPECT_FALSE(sweep.reading.scan->times.empty());
  EXPECT_EQ(assembler.description(), "");
}

TEST(SweepAssembler, flushesWhatIsHeldAndRefusesTinyRests) {
  std::vector<ScanReading> messages = Spinning{}.messages(3, 8);
  messages.resize(17);
  SweepAssembler assembler({});
  EXPECT_EQ(assemble(assembler, messages).size(), 2u);
  EXPECT_EQ(assembler.held(), 1u);
  const Sweeps rest = assembler.flush();
  ASSERT_EQ(rest.size(), 1u);
  EXPECT_EQ(rest[0].refusal, "too small a part of a sweep");
  EXPECT_EQ(assembler.held(), 0u);

  SweepAssembler undecided({});
  EXPECT_TRUE(undecided.take(messages[0]).empty());
  EXPECT_EQ(undecided.flush().size(), 1u);
}

TEST(SweepAssembler, parametersOverride) {
  ScanInputConfig messages;
  messages.sweeps = "messages";
  SweepAssembler none(messages);
  EXPECT_EQ(assemble(none, Spinning{}.messages(6, 2)).size(), 12u);
  ScanInputConfig longer;
  longer.scan_period = 0.2;
  SweepAssembler given(longer);
  const Sweeps sweeps = assemble(given, Spinning{}.messages(6, 2));
  ASSERT_EQ(sweeps.size(), 3u);
  EXPECT_EQ(sweeps[0].messages, 4u);
}

TEST(SweepAssembler, sensorsThatTakeTurnsAreNotJoined) {
  std::vector<ScanReading> messages = Spinning{}.messages(10, 2);
  for (std::size_t i = 0; i < messages.size(); i += 2) messages[i].frame_id = "other";
  SweepAssembler assembler({});
  EXPECT_EQ(assemble(assembler, messages).size(), messages.size());
}

TEST(SweepAssembler, aClockThatDoesNotAdvanceHoldsNothing) {
  std::vector<ScanReading> messages = Spinning{}.messages(10, 2);
  for (ScanReading& message : messages) message.scan->stamp = {0};
  SweepAssembler assembler({});
  EXPECT_EQ(assemble(assembler, messages).size(), messages.size());
}

}  // namespace
}  // namespace revisit_slam
