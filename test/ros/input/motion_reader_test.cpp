// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/motion_reader.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <limits>

#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {
namespace {

const Pose kMounting{expSO3({0.0, 0.0, 0.5 * M_PI}), {0.5, -0.2, 0.3}};

std::optional<Pose> findExtrinsics(const std::string& frame) {
  if (frame == "base_link") return Pose::identity();
  if (frame == "mounted") return kMounting;
  if (frame == "far away") return Pose{Eigen::Quaterniond::Identity(), {4000.0, 5000.0, 0.0}};
  return std::nullopt;
}

MotionReader::Result read(const MotionMessage& message, const PriorsConfig& config = {}) {
  MotionReader reader(config, {}, findExtrinsics);
  return reader.read(message).value();
}

boost::shared_ptr<nav_msgs::Odometry> odometry(const std::string& child) {
  auto message = boost::make_shared<nav_msgs::Odometry>();
  message->header.stamp = ros::Time(100.5);
  message->header.frame_id = "odom";
  message->child_frame_id = child;
  message->pose.pose = toPoseMessage({expSO3({0.0, 0.0, 0.3}), {1.0, 2.0, 0.0}});
  return message;
}

boost::shared_ptr<sensor_msgs::Imu> imu(const std::string& frame) {
  auto message = boost::make_shared<sensor_msgs::Imu>();
  message->header.stamp = ros::Time(100.5);
  message->header.frame_id = frame;
  message->angular_velocity.x = 0.1;
  return message;
}

TEST(MotionReader, AnOdometryOfTheBaseIsTakenAsItIs) {
  const auto reading = std::get<OdometryReading>(read(odometry("base_link")).reading.value());
  EXPECT_EQ(reading.stamp, Stamp::fromSeconds(100.5));
  EXPECT_LT((reading.T_world_base.translation - Eigen::Vector3d(1.0, 2.0, 0.0)).norm(), 1e-12);
  EXPECT_TRUE(reading.is_planar);
  EXPECT_FALSE(reading.velocity_covariance);
}

TEST(MotionReader, ThatOfAnotherFrameIsMovedToTheBase) {
  const auto message = odometry("mounted");
  message->twist.covariance[0] = 0.04;  // along the x axis of the frame, the y axis of the base
  message->twist.covariance[7] = 0.01;
  const auto reading = std::get<OdometryReading>(read(message).reading.value());
  const Pose T_world_child = reading.T_world_base * kMounting;
  EXPECT_LT((T_world_child.translation - Eigen::Vector3d(1.0, 2.0, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(reading.velocity_covariance->coeff(1, 1), 0.04, 1e-12);
  EXPECT_NEAR(reading.velocity_covariance->coeff(0, 0), 0.01, 1e-12);
}

TEST(MotionReader, ACovarianceThatSaysNothingIsUnknown) {
  for (const double first : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const auto message = odometry("base_link");
    message->twist.covariance[0] = first;
    EXPECT_FALSE(std::get<OdometryReading>(*read(message).reading).velocity_covariance) << first;
  }
}

TEST(MotionReader, AnOdometryWithTiltOrHeightIsNotPlanar) {
  const auto message = odometry("base_link");
  message->pose.pose.position.z = 0.1;
  EXPECT_FALSE(std::get<OdometryReading>(read(message).reading.value()).is_planar);
}

TEST(MotionReader, TurnRatesAreTurnedIntoTheAxesOfTheBase) {
  const auto message = imu("mounted");
  message->angular_velocity_covariance = {0.01, 0, 0, 0, 0.02, 0, 0, 0, 0.03};
  const auto reading = std::get<ImuReading>(read(message).reading.value());
  EXPECT_LT((reading.turn_rate - Eigen::Vector3d(0.0, 0.1, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(reading.turn_rate_variance.value(), 0.02, 1e-12);
}

TEST(MotionReader, AccelerationsAreTurnedIntoTheAxesOfTheBase) {
  const auto message = imu("mounted");
  EXPECT_FALSE(std::get<ImuReading>(read(message).reading.value()).acceleration);  // all zeros
  message->linear_acceleration.x = 0.5;
  message->linear_acceleration.z = 9.81;
  const auto reading = std::get<ImuReading>(read(message).reading.value());
  EXPECT_LT((reading.acceleration.value() - Eigen::Vector3d(0.0, 0.5, 9.81)).norm(), 1e-12);
  EXPECT_EQ(reading.p_base, kMounting.translation);
  message->linear_acceleration_covariance[0] = -1.0;
  EXPECT_FALSE(std::get<ImuReading>(read(message).reading.value()).acceleration);
}

TEST(MotionReader, WhatCannotBeUsedIsRejectedWithTheReason) {
  EXPECT_EQ(read(odometry("unknown")).rejection, "no transform from 'unknown'");
  EXPECT_EQ(read(odometry("")).rejection, "no child_frame_id");
  EXPECT_EQ(read(imu("")).rejection, "no frame_id");
  EXPECT_EQ(read(imu("far away")).rejection,
            "more than 100 m from the base frame: a wrong transform");
  const auto not_a_pose = odometry("base_link");
  not_a_pose->pose.pose.orientation.w = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(read(not_a_pose).rejection, "not a pose");
  const auto without_rate = imu("mounted");
  without_rate->angular_velocity_covariance[0] = -1.0;
  EXPECT_EQ(read(without_rate).rejection, "no turn rate");
  const auto without_stamp = imu("mounted");
  without_stamp->header.stamp = ros::Time();
  EXPECT_EQ(read(without_stamp).rejection, "no stamp");
}

TEST(MotionReader, TfOfTheFrameIsAnOdometryAndOtherTfIsNone) {
  PriorsConfig config;
  config.odometry_frame = "wheel_odom";
  MotionReader reader(config, {}, findExtrinsics);
  const auto message = boost::make_shared<tf2_msgs::TFMessage>();
  message->transforms.resize(2);
  message->transforms[0].header.frame_id = "base_link";
  message->transforms[0].child_frame_id = "wheel";
  EXPECT_FALSE(reader.read(tf2_msgs::TFMessage::ConstPtr(message)));
  geometry_msgs::TransformStamped& moved = message->transforms[1];
  moved.header.stamp = ros::Time(100.5);
  moved.header.frame_id = "wheel_odom";
  moved.child_frame_id = "base_link";
  moved.transform = toTransformMessage({expSO3({0.0, 0.0, 0.3}), {1.0, 2.0, 0.0}});
  const auto result = reader.read(tf2_msgs::TFMessage::ConstPtr(message));
  const auto reading = std::get<OdometryReading>(result.value().reading.value());
  EXPECT_EQ(reading.stamp, Stamp::fromSeconds(100.5));
  EXPECT_NEAR(reading.T_world_base.translation.y(), 2.0, 1e-12);
}

/// As tf, the predecessor of tf2, wrote them.
TEST(MotionReader, TfFramesMayHaveALeadingSlash) {
  PriorsConfig config;
  config.odometry_frame = "/wheel_odom";
  for (const char* frame : {"wheel_odom", "/wheel_odom"}) {
    MotionReader reader(config, {}, findExtrinsics);
    const auto message = boost::make_shared<tf2_msgs::TFMessage>();
    message->transforms.resize(1);
    message->transforms[0].header.stamp = ros::Time(100.5);
    message->transforms[0].header.frame_id = frame;
    message->transforms[0].child_frame_id = "base_link";
    message->transforms[0].transform.rotation.w = 1.0;
    const auto result = reader.read(tf2_msgs::TFMessage::ConstPtr(message));
    EXPECT_TRUE(result && result->reading) << frame;
  }
}

boost::shared_ptr<sensor_msgs::NavSatFix> position(const std::string& frame) {
  auto message = boost::make_shared<sensor_msgs::NavSatFix>();
  message->header.stamp = ros::Time(100.5);
  message->header.frame_id = frame;
  message->latitude = 48.1;
  message->longitude = 11.6;
  message->altitude = 520.0;
  message->position_covariance = {4.0, 0.5, 0.0, 0.5, 3.0, 0.0, 0.0, 0.0, 9.0};
  message->position_covariance_type = sensor_msgs::NavSatFix::COVARIANCE_TYPE_KNOWN;
  return message;
}

MotionReader::Result readFix(const sensor_msgs::NavSatFix::ConstPtr& message,
                             const GnssConfig& gnss = {}) {
  return MotionReader({}, gnss, findExtrinsics).read(message).value();
}

TEST(MotionReader, APositionIsThatOfTheAntennaAsTfPlacesIt) {
  const auto reading = std::get<GnssReading>(readFix(position("mounted")).reading.value());
  EXPECT_EQ(reading.stamp, Stamp::fromSeconds(100.5));
  EXPECT_EQ(reading.position.latitude, 48.1);
  EXPECT_EQ(reading.p_base, kMounting.translation);
  EXPECT_EQ(reading.covariance_enu(0, 0), 4.0);
  EXPECT_EQ(reading.covariance_enu(0, 1), 0.5);
}

TEST(MotionReader, AGivenAntennaNeedsNoTf) {
  GnssConfig gnss;
  gnss.antenna = "1 -2 0.5";
  const auto reading = std::get<GnssReading>(readFix(position("unknown"), gnss).reading.value());
  EXPECT_EQ(reading.p_base, Eigen::Vector3d(1.0, -2.0, 0.5));
  gnss.antenna = "1 -2";
  EXPECT_THROW(readFix(position("unknown"), gnss), ParameterError);
}

TEST(MotionReader, APositionWithoutCovarianceHasTheDeviationOfTheParameter) {
  for (const bool of_unknown_type : {true, false}) {
    const auto message = position("mounted");
    if (of_unknown_type)
      message->position_covariance_type = sensor_msgs::NavSatFix::COVARIANCE_TYPE_UNKNOWN;
    else
      message->position_covariance.assign(0.0);
    const auto reading = std::get<GnssReading>(readFix(message).reading.value());
    EXPECT_EQ(reading.covariance_enu(0, 0), 25.0);
    EXPECT_EQ(reading.covariance_enu(2, 2), 100.0);
  }
}

TEST(MotionReader, APositionWhoseMessageLeavesOutTheHeightsVarianceKeepsTheOthers) {
  const auto message = position("mounted");
  message->position_covariance = {0.01, 0.0, 0.0, 0.0, 0.02, 0.0, 0.0, 0.0, 0.0};
  const auto reading = std::get<GnssReading>(readFix(message).reading.value());
  EXPECT_EQ(reading.covariance_enu(0, 0), 0.01);
  EXPECT_EQ(reading.covariance_enu(2, 2), 0.08);
}

TEST(MotionReader, PositionsThatAreNoneAreNamed) {
  const auto very_bad = position("mounted");
  very_bad->position_covariance[0] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(readFix(very_bad).rejection, "covariance not finite");
  EXPECT_EQ(readFix(position("unknown")).rejection, "no transform from 'unknown'");
  EXPECT_EQ(readFix(position("")).rejection, "no frame_id");
  const auto without = position("mounted");
  without->status.status = sensor_msgs::NavSatStatus::STATUS_NO_FIX;
  EXPECT_EQ(readFix(without).rejection, "no fix");
  const auto nowhere = position("mounted");
  nowhere->latitude = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(readFix(nowhere).rejection, "not a position");
  GnssConfig far;
  far.antenna = "4000 5000 0";
  EXPECT_EQ(readFix(position("mounted"), far).rejection,
            "more than 100 m from the base frame: a wrong transform");
  const auto without_stamp = position("mounted");
  without_stamp->header.stamp = ros::Time();
  EXPECT_EQ(readFix(without_stamp).rejection, "no stamp");
}

}  // namespace
}  // namespace revisit_slam
