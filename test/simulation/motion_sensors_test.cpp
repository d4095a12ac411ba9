// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/motion_sensors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace revisit_slam::simulation {
namespace {

Route townRoute() {
  RouteConfig config;
  config.route = "loop";
  config.length = 400.0;
  config.seed = 3;
  return makeRoute(config);
}

TEST(MotionSensors, WheelsCountWrongByTheirScale) {
  const Route route = townRoute();
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    WheelConfig config;
    config.seed = seed;
    const std::vector<WheelReading> readings = simulateWheels(route, route.end(), config);
    double counted = 0.0, driven = 0.0;
    for (std::size_t i = 1; i < readings.size(); ++i) {
      counted +=
          (readings[i].T_odom_base.translation - readings[i - 1].T_odom_base.translation).norm();
      driven += (route.poseAt(readings[i].stamp).translation -
                 route.poseAt(readings[i - 1].stamp).translation)
                    .norm();
    }
    EXPECT_NEAR(std::abs(counted / driven - 1.0), 0.01, 0.003) << seed;
    EXPECT_EQ(readings.back().T_odom_base.translation.z(), 0.0);
  }
}

TEST(MotionSensors, PerfectWheelsKeepTheHeading) {
  const Route route = townRoute();
  WheelConfig perfect, noisy;
  perfect.heading_noise = 0.0;
  const auto headingErrorAtEnd = [&](const WheelConfig& config) {
    const std::vector<WheelReading> readings = simulateWheels(route, route.end(), config);
    const auto heading = [](const Pose& T) {
      const Eigen::Vector3d ahead = T.rotation * Eigen::Vector3d::UnitX();
      return std::atan2(ahead.y(), ahead.x());
    };
    const double error = heading(readings.back().T_odom_base) -
                         heading(route.poseAt(readings.back().stamp)) +
                         heading(route.poseAt(route.start()));
    return std::abs(std::remainder(error, 2.0 * M_PI));
  };
  EXPECT_LT(headingErrorAtEnd(perfect), 0.02);
  noisy.heading_noise = 1.0;
  EXPECT_GT(headingErrorAtEnd(noisy), headingErrorAtEnd(perfect));
}

TEST(MotionSensors, AnImuWithoutErrorsMeasuresTheMotion) {
  const Route route = townRoute();
  ImuConfig config;
  config.gyro_noise = config.gyro_bias = config.gyro_bias_walk = 0.0;
  config.acceleration_noise = config.acceleration_bias = 0.0;
  config.T_base_imu.rotation = expSO3({0.0, 0.0, 0.5 * M_PI});
  const Stamp end = route.start().plusSeconds(30.0);
  const std::vector<ImuSample> samples = simulateImu(route, end, config);
  const Pose T_map_first = route.poseAt(route.start()) * config.T_base_imu;
  Eigen::Quaterniond integrated = T_map_first.rotation;
  for (std::size_t i = 1; i < samples.size(); ++i)
    integrated = integrated * expSO3(0.5 / config.rate *
                                     (samples[i - 1].turn_rate_imu + samples[i].turn_rate_imu));
  const Pose T_map_last = route.poseAt(samples.back().stamp) * config.T_base_imu;
  EXPECT_LT(integrated.angularDistance(T_map_last.rotation), 2e-3);
}

/// Twice integrated the accelerations are where the unit went, turned and off the middle.
TEST(MotionSensors, AccelerationsAreThoseOfTheUnitAndOfGravity) {
  const Route route = townRoute();
  ImuConfig config;
  config.acceleration_noise = config.acceleration_bias = 0.0;
  config.T_base_imu = {expSO3({0.1, -0.2, 0.5 * M_PI}), {1.5, 0.4, 0.8}};
  const Stamp begin = route.start().plusSeconds(5.0);
  const std::vector<ImuSample> samples = simulateImu(route, begin.plusSeconds(8.0), config);
  const auto positionAt = [&](Stamp stamp) -> Eigen::Vector3d {
    return route.poseAt(stamp) * config.T_base_imu.translation;
  };
  const double h = 0.01;
  Eigen::Vector3d position = positionAt(begin);
  Eigen::Vector3d velocity =
      (positionAt(begin.plusSeconds(h)) - positionAt(begin.plusSeconds(-h))) / (2.0 * h);
  double greatest = 0.0;
  const double step = 1.0 / config.rate;
  for (const ImuSample& sample : samples) {
    if (sample.stamp < begin) continue;
    const Pose T_map_imu = route.poseAt(sample.stamp) * config.T_base_imu;
    const Eigen::Vector3d acceleration =
        T_map_imu.rotation * sample.acceleration_imu - Eigen::Vector3d(0.0, 0.0, 9.81);
    EXPECT_LT((position - T_map_imu.translation).norm(), 0.05);
    greatest = std::max(greatest, acceleration.norm());
    position += step * velocity + 0.5 * step * step * acceleration;
    velocity += step * acceleration;
  }
  EXPECT_GT(greatest, 0.5);
}

TEST(MotionSensors, NoiseIsAsLargeAsItIsSaidToBe) {
  const Route route = townRoute();
  ImuConfig perfect, noisy;
  perfect.gyro_noise = perfect.gyro_bias = perfect.gyro_bias_walk = 0.0;
  perfect.acceleration_noise = perfect.acceleration_bias = 0.0;
  noisy = perfect;
  noisy.gyro_noise = 0.05;
  noisy.acceleration_noise = 0.02;
  const Stamp end = route.start().plusSeconds(20.0);
  const auto truth = simulateImu(route, end, perfect), samples = simulateImu(route, end, noisy);
  double turn = 0.0, force = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    turn += (samples[i].turn_rate_imu - truth[i].turn_rate_imu).squaredNorm();
    force += (samples[i].acceleration_imu - truth[i].acceleration_imu).squaredNorm();
  }
  const double axes = 3.0 * static_cast<double>(samples.size()), root = std::sqrt(noisy.rate);
  EXPECT_NEAR(std::sqrt(turn / axes) / root, 0.05 * M_PI / 180.0, 0.05 * 0.05 * M_PI / 180.0);
  EXPECT_NEAR(std::sqrt(force / axes) / root, 0.02, 0.05 * 0.02);
}

TEST(MotionSensors, TheSameSeedGivesTheSameReadingsAndAnotherOnesDoNot) {
  const Route route = townRoute();
  const Stamp end = route.start().plusSeconds(1.0);
  ImuConfig config, other;
  other.seed = 2;
  const auto last = [&](const ImuConfig& used) {
    return simulateImu(route, end, used).back().turn_rate_imu;
  };
  EXPECT_EQ(last(config), last(config));
  EXPECT_GT((last(config) - last(other)).norm(), 1e-3);
}

}  // namespace
}  // namespace revisit_slam::simulation
