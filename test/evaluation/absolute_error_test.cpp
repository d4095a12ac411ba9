// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/absolute_error.h"

#include <gtest/gtest.h>

#include "evaluation/evaluation_fixtures.h"
#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

TEST(AbsoluteError, IsZeroForARigidlyMovedEstimateAndFindsTheMotion) {
  RandomNumbers random(1);
  const Trajectory reference = windingDrive(200);
  const Pose T = random.pose(1000.0);
  const AbsoluteError error = absoluteError(matchOf(moved(T, reference), reference));
  EXPECT_LT(error.max, 1e-9);
  EXPECT_LT(log(error.T_reference_estimate * T).norm(), 1e-9);
}

TEST(AbsoluteError, OfAlternatingOffsetsIsTheirSize) {
  const Trajectory reference = straightDrive(400);
  Trajectory estimate = reference;
  for (std::size_t i = 0; i < estimate.size(); ++i)
    estimate[i].T_world_base.translation.y() += i % 4 == 0 || i % 4 == 3 ? 0.3 : -0.3;
  estimate.back() = reference.back();
  const AbsoluteError error = absoluteError(matchOf(estimate, reference));
  ASSERT_EQ(error.per_pose.size(), 400u);
  EXPECT_NEAR(error.rmse, 0.3, 1e-3);
  EXPECT_NEAR(error.median, 0.3, 1e-3);
  EXPECT_NEAR(error.max, 0.3, 4e-3);
  EXPECT_NEAR(error.per_pose.back(), 0.0, 4e-3);
  EXPECT_LT(error.mean, error.rmse);
}

TEST(AbsoluteError, DoesNotHideAnErrorOfScale) {
  const Trajectory reference = straightDrive(101);
  Trajectory estimate = reference;
  for (StampedPose& pose : estimate) pose.T_world_base.translation *= 1.1;
  EXPECT_NEAR(absoluteError(matchOf(estimate, reference)).max, 5.0, 1e-9);
}

TEST(AbsoluteError, NeedsThreePoses) {
  EXPECT_THROW(absoluteError(matchOf(straightDrive(2), straightDrive(5))), std::runtime_error);
}

}  // namespace
}  // namespace revisit_slam
