// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/localization_messages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace revisit_slam {
namespace {

TEST(LocalizationMessages, AStatusSaysWhereAndHowWell) {
  Localization now;
  now.stamp = Stamp::fromSeconds(12.5);
  now.state = LocalizationState::lost;
  now.reason = "off the map";
  now.T_map_base = {expSO3({0, 0, M_PI / 2}), {1, 2, 3}};
  now.covariance(0, 0) = 4.0;  // along the base's x, which is the map's y
  now.target = SubmapId{7};
  const LocalizationStatus status = toStatus(now, "map");
  EXPECT_EQ(status.header.frame_id, "map");
  EXPECT_EQ(status.header.stamp.toSec(), 12.5);
  EXPECT_EQ(status.state, "lost");
  EXPECT_EQ(status.reason, "off the map");
  EXPECT_EQ(status.pose.pose.position.z, 3.0);
  EXPECT_NEAR(status.pose.covariance[0], 0.0, 1e-9);
  EXPECT_NEAR(status.pose.covariance[7], 4.0, 1e-9);
  EXPECT_EQ(status.target, 7u);
}

TEST(LocalizationMessages, TheStateStandsAboveTheBaseOrWhereTheMapBegins) {
  Localization now;
  now.T_map_base.translation = {1, 2, 3};
  const visualization_msgs::Marker searching = toStateText(now, {7, 8, 9}, "map");
  EXPECT_EQ(searching.header.frame_id, "map");
  EXPECT_EQ(searching.text, "searching");
  EXPECT_EQ(searching.pose.position.x, 7.0);
  EXPECT_GT(searching.pose.position.z, 9.0);
  now.state = LocalizationState::lost;
  now.reason = "off the map";
  const visualization_msgs::Marker lost = toStateText(now, {7, 8, 9}, "map");
  EXPECT_EQ(lost.text, "lost: off the map");
  EXPECT_EQ(lost.pose.position.x, 1.0);
  EXPECT_GT(lost.color.r, lost.color.g);
  now.state = LocalizationState::localized;
  now.reason = "";
  const std_msgs::ColorRGBA localized = toStateText(now, {}, "map").color;
  EXPECT_GT(localized.g, localized.r);
}

TEST(LocalizationMessages, WhatIsDrawnLiesOnTheMapsGround) {
  PriorMap map;
  map.T_map_scan = {{Eigen::Quaterniond::Identity(), {0, 0, 5}}};
  geometry_msgs::PoseWithCovarianceStamped drawn;
  drawn.header.frame_id = "/map";
  drawn.pose.pose.position.x = 2.0;
  drawn.pose.pose.orientation.z = drawn.pose.pose.orientation.w = std::sqrt(0.5);
  const std::optional<Pose> start = toStart(drawn, "map", map);
  ASSERT_TRUE(start);
  EXPECT_NEAR((start->translation - Eigen::Vector3d(2, 0, 5)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((start->rotation * Eigen::Vector3d::UnitX()).y(), 1.0, 1e-9);
  drawn.header.frame_id = "odom";
  EXPECT_FALSE(toStart(drawn, "map", map));
  drawn.header.frame_id = "map";
  drawn.pose.pose.position.x = std::nan("");
  EXPECT_FALSE(toStart(drawn, "map", map));
}

}  // namespace
}  // namespace revisit_slam
