// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_decision.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

const Stamp now{1'700'000'000'000'000'000};
const PointField float_field{"t", NumberType::float32, 0};
const PointField integer_field{"t", NumberType::uint32, 0};

TimeRange range(double first, double last, std::size_t count = 1000) {
  return {first, last, count};
}

TimeDecision decide(const PointField& field, const TimeRange& range,
                    const TimeOverrides& overrides = {}, std::optional<TimeSource> prior = {},
                    Stamp header = now) {
  return decideTimeSource(field, range, header, overrides, prior);
}

void expectSource(const TimeDecision& decision, TimeUnit unit, TimeOrigin origin) {
  ASSERT_TRUE(decision.source) << decision.reason;
  EXPECT_EQ(decision.source->unit, unit) << toString(decision.source->unit);
  EXPECT_EQ(decision.source->origin, origin) << toString(decision.source->origin);
}

TEST(TimeDecision, everyUnitAndOriginIsRecognised) {
  for (const TimeUnit unit : time_units) {
    for (const double duration : {0.02, 0.0998, 0.5}) {
      const double one = 1.0 / secondsIn(unit);
      const double sweep = duration * one;
      const double header = now.toSeconds() * one;
      for (const PointField& field : {float_field, integer_field}) {
        expectSource(decide(field, range(0, sweep)), unit, TimeOrigin::relative);
        expectSource(decide(field, range(-sweep, 0)), unit, TimeOrigin::relative);
        expectSource(decide(field, range(header, header + sweep)), unit, TimeOrigin::absolute);
        expectSource(decide(field, range(header - sweep, header)), unit, TimeOrigin::absolute);
        expectSource(decide(field, range(1234 * one, 1234 * one + sweep)), unit,
                     TimeOrigin::own_clock);
        expectSource(decide(field, range(header + 37 * one, header + 37 * one + sweep)), unit,
                     TimeOrigin::own_clock);
      }
    }
  }
}

TEST(TimeDecision, timesMayReachPastTheHeaderOnBothSides) {
  expectSource(decide(float_field, range(-0.099, 0.0006)), TimeUnit::s, TimeOrigin::relative);
}

TEST(TimeDecision, theNameDecidesForSweepsOfUnusualDuration) {
  const PointField named{"time_offset_ns", NumberType::uint32, 0};
  expectSource(decide(named, range(0, 500'000)), TimeUnit::ns, TimeOrigin::relative);
  expectSource(decide(integer_field, range(0, 500'000)), TimeUnit::us, TimeOrigin::relative);
  expectSource(decide(float_field, range(0, 1.02)), TimeUnit::s, TimeOrigin::relative);
}

TEST(TimeDecision, simulatorsStartTheirClockAtZero) {
  const Stamp start{5'000'000'000};
  expectSource(decide(float_field, range(4.9, 5.0), {}, {}, start), TimeUnit::s,
               TimeOrigin::absolute);
  expectSource(decide(float_field, range(0.0, 0.1), {}, {}, start), TimeUnit::s,
               TimeOrigin::relative);
}

TEST(TimeDecision, absoluteTimesNeedNoHeaderStamp) {
  expectSource(decide(float_field, range(1.7e9, 1.7e9 + 0.1), {}, {}, Stamp{0}), TimeUnit::s,
               TimeOrigin::absolute);
}

TEST(TimeDecision, constantTimesAreNone) {
  const TimeDecision decision = decide(float_field, range(0, 0));
  EXPECT_EQ(decision.fault, TimeFault::constant);
  EXPECT_EQ(decision.reason, "field 't' is constant");
}

TEST(TimeDecision, aSweepInNoUnitIsImplausible) {
  const TimeDecision decision = decide(float_field, range(0, 1e18));
  EXPECT_EQ(decision.fault, TimeFault::implausible);
  EXPECT_NE(decision.reason.find("1e+18"), std::string::npos) << decision.reason;
}

TEST(TimeDecision, aPriorStaysWhileItIsPossible) {
  const TimeSource prior{TimeUnit::s, TimeOrigin::relative, SweepInstant::time_zero};
  EXPECT_EQ(*decide(float_field, range(0.01, 0.0101, 5), {}, prior).source, prior);
  EXPECT_EQ(*decide(float_field, range(0.01, 0.01, 5), {}, prior).source, prior);
  EXPECT_EQ(decide(float_field, range(0, 0), {}, prior).fault, TimeFault::constant);
}

TEST(TimeDecision, aPriorThatIsContradictedGoes) {
  const TimeSource seconds{TimeUnit::s, TimeOrigin::relative, SweepInstant::time_zero};
  expectSource(decide(float_field, range(0, 99.8), {}, seconds), TimeUnit::ms,
               TimeOrigin::relative);
  const double header = now.toSeconds();
  expectSource(decide(float_field, range(header, header + 0.1), {}, seconds), TimeUnit::s,
               TimeOrigin::absolute);
}

TEST(TimeDecision, anHourlyCounterDoesNotTurnRelativeAtTheHour) {
  const auto counter = decide(integer_field, range(1.8e9, 1.8e9 + 1e5)).source;
  ASSERT_TRUE(counter);
  EXPECT_EQ(*decide(integer_field, range(0, 1e5), {}, counter).source, *counter);
}

TEST(TimeDecision, parametersAreObeyed) {
  TimeOverrides overrides;
  overrides.unit = TimeUnit::us;
  expectSource(decide(integer_field, range(0, 900), overrides), TimeUnit::us, TimeOrigin::relative);
  overrides.origin = TimeOrigin::absolute;
  const double an_hour_off = now.toSeconds() * 1e6 + 3e9;
  expectSource(decide(integer_field, range(an_hour_off, an_hour_off + 1e5), overrides),
               TimeUnit::us, TimeOrigin::absolute);
}

TEST(TimeDecision, parametersThatCannotBeAreNamed) {
  TimeOverrides unit;
  unit.unit = TimeUnit::s;
  const TimeDecision too_long = decide(integer_field, range(0, 9.98e7), unit);
  EXPECT_EQ(too_long.fault, TimeFault::contradicts_parameter);
  EXPECT_NE(too_long.reason.find("time_unit: s"), std::string::npos) << too_long.reason;
  TimeOverrides absolute;
  absolute.origin = TimeOrigin::absolute;
  EXPECT_EQ(decide(float_field, range(0, 0.1), absolute).fault, TimeFault::contradicts_parameter);
  TimeOverrides relative;
  relative.origin = TimeOrigin::relative;
  const TimeRange absolute_times = range(now.toSeconds(), now.toSeconds() + 0.1);
  EXPECT_EQ(decide(float_field, absolute_times, relative).fault, TimeFault::contradicts_parameter);
  relative.header = SweepInstant::first;
  expectSource(decide(float_field, absolute_times, relative), TimeUnit::s, TimeOrigin::own_clock);
}

}  // namespace
}  // namespace revisit_slam
