// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/estimate_judge.h"

#include <gtest/gtest.h>

#include "evaluation/evaluation_fixtures.h"

namespace revisit_slam {
namespace {

/// One wall point, 20 m before the drive's first pose, seen at the start and at the end of a sweep
/// while the base drives 1 m towards it.
Scan sweepTowardsAPoint(std::size_t index) {
  const auto x = static_cast<float>(index);
  return {
      stampOf(index), {{21.0f - x, 0, 0}, {20.0f - x, 0, 0}}, {-0.1f, 0.0f}, Pose::identity(), {}};
}

TEST(PointsAlong, TakeOutTheMotionThatTheEstimateHas) {
  const auto points = pointsAlong(PoseInterpolator(straightDrive(10)), sweepTowardsAPoint(4), {});
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 2u);
  EXPECT_LT(((*points)[0] - Eigen::Vector3f(16, 0, 0)).norm(), 1e-4f);
  EXPECT_LT(((*points)[1] - Eigen::Vector3f(16, 0, 0)).norm(), 1e-4f);
}

TEST(PointsAlong, StayAsTheyAreWithoutTimesAndAreNothingWithoutAPose) {
  const PoseInterpolator estimate(straightDrive(10));
  Scan scan = sweepTowardsAPoint(4);
  scan.times.clear();
  EXPECT_EQ(pointsAlong(estimate, scan, {})->at(0), Eigen::Vector3f(17, 0, 0));
  EXPECT_FALSE(pointsAlong(estimate, sweepTowardsAPoint(0), {}));  // begins before the estimate
  EXPECT_FALSE(pointsAlong(estimate, sweepTowardsAPoint(12), {}));
}

TEST(EstimateJudge, CountsTheScansOfRevisits) {
  Trajectory drive = straightDrive(20), back = straightDrive(20);
  for (StampedPose& pose : back) pose.stamp = pose.stamp.plusSeconds(100.0);
  drive.insert(drive.end(), back.begin(), back.end());
  Trajectory estimate(drive.begin() + 5, drive.end());
  EstimateJudge judge("a", PoseInterpolator(estimate), PoseInterpolator(drive), {});
  for (std::size_t i = 0; i < 30; ++i) judge.insert(sweepTowardsAPoint(i), {});
  judge.compareMaps();
  EXPECT_EQ(judge.evaluation().scans_used, 14u);         // 6 … 19
  EXPECT_EQ(judge.evaluation().scans_without_pose, 6u);  // 0 … 5: 5 has no start
  ASSERT_TRUE(judge.evaluation().consistency);
  EXPECT_EQ(judge.evaluation().consistency->cells_without_pairs, 2u);
  EXPECT_EQ(judge.evaluation().trajectory->match.estimate.size(), 35u);
}

TEST(EstimateJudge, NeedsNoReference) {
  EstimateJudge judge("a", PoseInterpolator(straightDrive(20)), std::nullopt, {});
  EXPECT_FALSE(judge.evaluation().trajectory);
  EXPECT_EQ(judge.evaluation().estimate.size(), 20u);
}

}  // namespace
}  // namespace revisit_slam
