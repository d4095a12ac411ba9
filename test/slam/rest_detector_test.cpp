// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/rest_detector.h"

#include <gtest/gtest.h>

#include <vector>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

constexpr double kPeriod = 0.1;  // s

/// Which of so many scans count, at the places that `placeOf(i)` gives.
template <typename PlaceOf>
std::vector<int> counted(double interval, int scans, const PlaceOf& placeOf) {
  RestDetector detector(interval);
  std::vector<int> counted;
  for (int i = 0; i < scans; ++i)
    if (!detector.repeats(Stamp::fromSeconds(100.0 + kPeriod * i), placeOf(i)))
      counted.push_back(i);
  return counted;
}

Pose at(double x) {
  return {Eigen::Quaterniond::Identity(), {x, 0.0, 0.0}};
}

/// What an odometry at rest gives.
Pose jittering(int i) {
  return {expSO3({0.0, 0.0, 0.005 * std::sin(7.0 * i)}), {0.03 * std::cos(5.0 * i), 0.0, 0.0}};
}

TEST(RestDetector, oneScanInAnIntervalCountsAtRest) {
  const std::vector<int> kept = counted(2.0, 36000, jittering);
  EXPECT_NEAR(static_cast<double>(kept.size()), 3600.0 / 2.0, 40.0);
  for (int i = 0; i < 30; ++i) EXPECT_EQ(kept[i], i);  // who stops for a moment is on the way
  for (std::size_t i = 31; i < kept.size(); ++i) EXPECT_EQ(kept[i] - kept[i - 1], 20);
}

TEST(RestDetector, everyScanCountsInMotion) {
  EXPECT_EQ(counted(2.0, 200, [](int i) { return at(0.1 * i); }).size(), 200u);
  // A robot that creeps leaves the dead band in less than the time that it takes to settle.
  EXPECT_EQ(counted(2.0, 200, [](int i) { return at(0.005 * i); }).size(), 200u);
  EXPECT_EQ(counted(2.0, 200,
                    [](int i) {
                      return Pose{expSO3({0, 0, 0.01 * i}), {0, 0, 0}};
                    })
                .size(),
            200u);
}

TEST(RestDetector, theFirstScanThatMovesCounts) {
  const std::vector<int> kept =
      counted(2.0, 105, [](int i) { return at(i < 101 ? 0.0 : 0.2 * (i - 100)); });
  ASSERT_GE(kept.size(), 4u);
  EXPECT_EQ(std::vector<int>(kept.end() - 4, kept.end()), (std::vector<int>{101, 102, 103, 104}));
}

TEST(RestDetector, withoutAnIntervalEveryScanCounts) {
  EXPECT_EQ(counted(0.0, 200, jittering).size(), 200u);
}

}  // namespace
}  // namespace revisit_slam
