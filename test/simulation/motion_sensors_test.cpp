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
