// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/fit_judge.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

constexpr std::size_t kPoints = 1000;

/// Of a scan without anything that is alike at many places.
Fit fit(double explained) {
  return {explained, explained};
}

/// After scans of which the map explained 80 %, more or less.
FitJudge settledJudge(double more_or_less = 0.06, const FitConfig& config = {}) {
  FitJudge judge(config);
  for (int i = 0; i < 20; ++i) {
    judge.observe(fit(0.8 + more_or_less), PoseVerdict::good);
    judge.observe(fit(0.8 - more_or_less), PoseVerdict::good);
  }
  return judge;
}

TEST(FitJudge, comparesAScanWithThoseBefore) {
  const FitJudge judge = settledJudge();
  EXPECT_NEAR(judge.usual(), 0.826, 0.002);                       // nearer to the better ones
  EXPECT_EQ(judge.judge(fit(0.51), kPoints), PoseVerdict::good);  // 0.6 of what is usual is 0.50
  EXPECT_EQ(judge.judge(fit(0.48), kPoints), PoseVerdict::poor);
  EXPECT_EQ(judge.judge(fit(0.25), kPoints), PoseVerdict::poor);
  EXPECT_EQ(judge.judge(fit(0.23), kPoints), PoseVerdict::lost);
}

TEST(FitJudge, aPoseFarFromThePredictionIsPoorHoweverItFits) {
  const FitJudge judge = settledJudge();
  const double jump = FitConfig().jump;
  EXPECT_EQ(judge.judge(fit(0.9), kPoints, 0.9 * jump), PoseVerdict::good);
  EXPECT_EQ(judge.judge(fit(0.9), kPoints, 1.1 * jump), PoseVerdict::poor);
  EXPECT_EQ(judge.judge(fit(0.1), kPoints, 1.1 * jump), PoseVerdict::lost);
  FitConfig any;
  any.jump = 0.0;
  EXPECT_EQ(settledJudge(0.06, any).judge(fit(0.9), kPoints, 1e6), PoseVerdict::good);
}

TEST(FitJudge, whatSeesThroughMuchMoreOfTheMapThanTheScanBeforeIsContradicted) {
  const FitJudge judge = settledJudge();
  EXPECT_TRUE(judge.isContradicted(0.14, 0.02));
  EXPECT_FALSE(judge.isContradicted(0.04, 0.0));
  EXPECT_FALSE(judge.isContradicted(0.3, 0.2));  // traffic has left planes
  EXPECT_FALSE(FitJudge(FitConfig()).isContradicted(0.5, 0.0));
  FitConfig never;
  never.through = 0.0;
  EXPECT_FALSE(settledJudge(0.06, never).isContradicted(0.5, 0.0));
}

TEST(FitJudge, aFitThatWorsensLittleByLittleIsNotUsualSoon) {
  FitJudge judge = settledJudge(0.02);
  double explained = 0.8;
  int scans = 0;
  for (; judge.judge(fit(explained), kPoints) == PoseVerdict::good && scans < 1000; ++scans) {
    judge.observe(fit(explained), PoseVerdict::good);
    explained -= 0.005;
  }
  EXPECT_LT(scans, 80);
  EXPECT_GT(explained, 0.4);
}

/// From a street to a field, all but what stands beside it fits; elsewhere little else does.
TEST(FitJudge, isNotLostWhereOnlyTheGroundIsInView) {
  const FitJudge judge = settledJudge();
  EXPECT_EQ(judge.judge({0.2, 0.6}, kPoints), PoseVerdict::poor);
  EXPECT_EQ(judge.judge({0.2, 0.4}, kPoints), PoseVerdict::lost);
  FitJudge of_fields{FitConfig{}};
  for (int i = 0; i < 40; ++i) of_fields.observe({0.25, 0.7}, PoseVerdict::good);
  EXPECT_EQ(of_fields.judge({0.25, 0.7}, kPoints), PoseVerdict::good);
}

TEST(FitJudge, noticesWhenASteadyFitBecomesWorseAtOnce) {
  EXPECT_EQ(settledJudge(0.06).judge(fit(0.6), kPoints), PoseVerdict::good);
  EXPECT_EQ(settledJudge(0.003).judge(fit(0.6), kPoints), PoseVerdict::good);  // eight times 0.03
  EXPECT_EQ(settledJudge(0.003).judge(fit(0.55), kPoints), PoseVerdict::poor);
  EXPECT_EQ(settledJudge(0.003).judge(fit(0.25), kPoints), PoseVerdict::poor);  // but not lost
}

TEST(FitJudge, asksLittleOfTheFirstScansOfAMap) {
  FitJudge judge{FitConfig{}};
  EXPECT_EQ(judge.judge(fit(0.0), kPoints), PoseVerdict::good);  // there is no map
  judge.observe(fit(0.0), PoseVerdict::good);
  EXPECT_EQ(judge.judge(fit(0.32), kPoints), PoseVerdict::good);
  EXPECT_EQ(judge.judge(fit(0.28), kPoints), PoseVerdict::poor);
  judge.observe(fit(0.2), PoseVerdict::good);
  judge.observe(fit(0.4), PoseVerdict::good);
  EXPECT_NEAR(judge.usual(), 0.3, 1e-12);
}

TEST(FitJudge, aCoveredSensorIsNotElsewhere) {
  EXPECT_EQ(settledJudge().judge(fit(0.0), 20), PoseVerdict::poor);
}

TEST(FitJudge, surroundingsThatHaveChangedBecomeUsual) {
  FitJudge judge = settledJudge();
  int poor = 0;
  while (judge.judge(fit(0.45), kPoints) == PoseVerdict::poor && poor < 1000) {
    judge.observe(fit(0.45), PoseVerdict::poor);
    ++poor;
  }
  EXPECT_GT(poor, 5);
  EXPECT_LT(poor, 100);
}

TEST(FitJudge, neverLostWhereThatIsSwitchedOff) {
  FitConfig config;
  config.lost = 0.0;
  EXPECT_EQ(settledJudge(0.0, config).judge(fit(0.0), kPoints), PoseVerdict::poor);
}

}  // namespace
}  // namespace revisit_slam
