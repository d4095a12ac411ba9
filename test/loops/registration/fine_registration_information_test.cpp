// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/registration/fine_registration_information.h"

#include <gtest/gtest.h>

#include "support/synthetic_street.h"

namespace revisit_slam {
namespace {

/// Lambda_lc of a drive that is turned by `yaw` against the first one.
Matrix6 informationIn(SyntheticStreet first, SyntheticStreet second, double yaw) {
  std::vector<Pose> poses = drive(0, 25);
  const Submap target = submapOf(first, poses);
  for (Pose& T : poses) T = T * poseAt(0, 0.3, yaw);
  const Submap source = submapOf(second, poses);
  return LoopInformation({}, {})
      .estimate(source, std::make_shared<const Submap>(target),
                target.T_odom_submap.inverse() * source.T_odom_submap)
      .information;
}

double along(const Matrix6& information, const Eigen::Vector3d& direction) {
  return direction.dot(information.topLeftCorner<3, 3>() * direction);
}

TEST(LoopInformation, IsWeakAlongACorridor) {
  const Matrix6 L = informationIn(SyntheticStreet::corridor(1), SyntheticStreet::corridor(2), 0.1);
  const Eigen::Vector3d corridor(std::cos(0.1), -std::sin(0.1), 0);
  const Eigen::Vector3d across(std::sin(0.1), std::cos(0.1), 0);
  EXPECT_LT(along(L, corridor), 0.1 * along(L, across));
}

TEST(LoopInformation, IsInTheFrameOfTheSource) {
  const Matrix6 L =
      informationIn(SyntheticStreet::corridor(1), SyntheticStreet::corridor(2), M_PI / 2);
  EXPECT_LT(L(1, 1), 0.1 * L(0, 0));  // the source looks across: the corridor is along its y
}

TEST(LoopInformation, IsTheIdentityWhenSwitchedOff) {
  InformationConfig config;
  config.enabled = false;
  EXPECT_EQ(LoopInformation(config, {}).estimate({}, nullptr, {}).information,
            Matrix6(Matrix6::Identity()));
}

}  // namespace
}  // namespace revisit_slam
