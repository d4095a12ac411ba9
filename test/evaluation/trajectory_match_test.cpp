// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/trajectory_match.h"

#include <gtest/gtest.h>

#include "evaluation/evaluation_fixtures.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

TEST(TrajectoryMatch, TakesTheReferenceAtTheStampsOfTheEstimateAndCountsTheRest) {
  Trajectory reference = straightDrive(40);
  reference.erase(reference.begin() + 10, reference.begin() + 25);  // from pose 9 to 25: 1.6 s
  Trajectory estimate;
  for (int i = -3; i < 41; ++i)  // between the poses of the reference
    estimate.push_back({stampOf(0).plusSeconds(kPeriod * (i + 0.5)), Pose::identity()});
  const TrajectoryMatch match = matchOf(estimate, reference);
  EXPECT_EQ(match.outside, 3u + 2u);
  EXPECT_EQ(match.in_gap, 16u);
  ASSERT_EQ(match.estimate.size(), 39u - 16u);
  ASSERT_EQ(match.reference.size(), match.estimate.size());
  EXPECT_NEAR(match.reference[3].T_world_base.translation.x(), 3.5, 1e-6);
  EXPECT_EQ(match.reference[3].stamp, match.estimate[3].stamp);
}

TEST(ReadTrajectory, GivesKittiPosesTheStampsOfTheReference) {
  const TemporaryFolder folder;
  const Trajectory reference = straightDrive(5), written = windingDrive(5);
  writeKitti(folder.file("a.txt"), written);
  const Trajectory read = readTrajectory(folder.file("a.txt"), reference);
  ASSERT_EQ(read.size(), 5u);
  EXPECT_EQ(read[4].stamp, reference[4].stamp);
  EXPECT_LT(log(read[4].T_world_base.inverse() * written[4].T_world_base).norm(), 1e-9);
}

TEST(ReadTrajectory, RefusesKittiPosesThatTheReferenceDoesNotNumber) {
  const TemporaryFolder folder;
  writeKitti(folder.file("a.txt"), windingDrive(5));
  EXPECT_THROW(readTrajectory(folder.file("a.txt"), straightDrive(6)), std::runtime_error);
  EXPECT_THROW(readTrajectory(folder.file("a.txt")), std::runtime_error);
}

TEST(ReadTrajectory, ReadsTumAndRefusesAFileWithoutPoses) {
  const TemporaryFolder folder;
  writeTum(folder.file("a.tum"), windingDrive(5));
  EXPECT_EQ(readTrajectory(folder.file("a.tum")).size(), 5u);
  EXPECT_THROW(readTrajectory(folder.with("b.tum", "# nothing\n")), std::runtime_error);
}

}  // namespace
}  // namespace revisit_slam
