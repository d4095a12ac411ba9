// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/stamp_gate.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

ScanReading readingAt(double seconds) {
  ScanReading reading;
  reading.scan.emplace();
  reading.scan->stamp = Stamp::fromSeconds(seconds);
  return reading;
}

class StampGateTest : public testing::Test {
 protected:
  void take(double seconds) { keep(gate_.take(readingAt(seconds))); }
  void flush() { keep(gate_.flush()); }
  /// 10 Hz, `count` scans.
  void drive(double from, int count) {
    for (int i = 0; i < count; ++i) take(from + 0.1 * i);
  }

  void keep(const std::vector<StampGate::Decision>& decisions) {
    for (const StampGate::Decision& decision : decisions) {
      if (decision.went_back) restarts_.push_back(*decision.went_back);
      if (decision.refusal.empty())
        passed_.push_back(decision.reading.scan->stamp.toSeconds());
      else
        refused_.push_back(decision.refusal);
    }
  }

  StampGate gate_{1.0, 5};
  std::vector<double> passed_, restarts_;
  std::vector<std::string> refused_;
};

TEST_F(StampGateTest, scansInOrderGoOnAtOnce) {
  drive(100.0, 20);
  EXPECT_EQ(passed_.size(), 20u);
  EXPECT_EQ(gate_.held(), 0u);
}

TEST_F(StampGateTest, oneStampAheadCostsThatScanAlone) {
  drive(100.0, 20);
  take(100.0 + 604800.0);
  drive(102.1, 30);
  EXPECT_EQ(passed_.size(), 50u);
  EXPECT_EQ(refused_, std::vector<std::string>{"stamp ahead of the next one"});
  EXPECT_TRUE(restarts_.empty());
}

TEST_F(StampGateTest, aStampAFewPeriodsAheadCostsThatScanAlone) {
  drive(100.0, 20);
  take(102.0 + 0.8);  // one point's time was wrong
  drive(102.1, 30);
  EXPECT_EQ(passed_.size(), 50u);
  EXPECT_EQ(refused_.size(), 1u);
  EXPECT_TRUE(restarts_.empty());
}

TEST_F(StampGateTest, aMissingScanOrTwoIsNoGap) {
  drive(100.0, 10);
  take(101.1);
  take(101.4);
  EXPECT_EQ(passed_.size(), 12u);
}

TEST_F(StampGateTest, twoSensorsThatTakeTurnsAreNotHeld) {
  for (int i = 0; i < 40; ++i) take(100.0 + 0.1 * (i / 2) + 0.01 * (i % 2));
  EXPECT_EQ(passed_.size(), 40u);
}

TEST_F(StampGateTest, aGapCostsNothing) {
  drive(100.0, 5);
  drive(130.0, 5);
  EXPECT_EQ(passed_.size(), 10u);
  EXPECT_TRUE(refused_.empty());
}

TEST_F(StampGateTest, anExpectedGapOfSomePeriodsNeedsNoConfirmation) {
  drive(100.0, 5);
  gate_.expectGap();
  take(101.2);
  EXPECT_EQ(passed_.size(), 6u);
  gate_.expectGap();
  take(604800.0);
  EXPECT_EQ(gate_.held(), 1u);
}

TEST_F(StampGateTest, scansFarBetweenAllGoOn) {
  for (int i = 0; i < 10; ++i) take(100.0 + 2.0 * i);
  EXPECT_EQ(passed_.size(), 9u);
  flush();  // nothing contradicts the last one
  EXPECT_EQ(passed_.size(), 10u);
}

TEST_F(StampGateTest, aClockSetBackBeginsASessionAndNoScanOfTheNewClockIsLost) {
  drive(137.0, 50);
  drive(105.0, 50);
  EXPECT_EQ(passed_.size(), 100u);
  ASSERT_EQ(restarts_.size(), 1u);
  EXPECT_NEAR(restarts_[0], 36.9, 1e-6);
  EXPECT_TRUE(refused_.empty());
}

TEST_F(StampGateTest, lateScansAreRefusedWhenTheNextInOrderComes) {
  drive(100.0, 10);
  take(100.25);
  take(100.35);
  EXPECT_EQ(gate_.held(), 2u);
  drive(101.0, 5);
  EXPECT_EQ(passed_.size(), 15u);
  EXPECT_EQ(refused_, (std::vector<std::string>{"time went back", "time went back"}));
}

TEST_F(StampGateTest, oldScansInDisorderAreNoOtherClock) {
  drive(100.0, 10);
  for (int i = 0; i < 20; ++i) take(90.0 - i);
  EXPECT_EQ(passed_.size(), 10u);
  EXPECT_EQ(refused_.size() + gate_.held(), 20u);
}

TEST_F(StampGateTest, duplicatesAreRefused) {
  drive(100.0, 3);
  take(100.2);
  EXPECT_EQ(refused_, std::vector<std::string>{"duplicate stamp"});
}

TEST_F(StampGateTest, afterARestartAnyStampIsWelcome) {
  drive(100.0, 3);
  gate_.restart();
  take(5.0);
  EXPECT_EQ(passed_.size(), 4u);
}

}  // namespace
}  // namespace revisit_slam
