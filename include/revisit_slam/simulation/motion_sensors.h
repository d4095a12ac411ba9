// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/simulation/route.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam::simulation {

/// An odometer on the wheels and a heading from them: planar, as most are.
struct WheelConfig {
  std::uint64_t seed = 1;
  double rate = 50.0;           ///< Hz
  double scale_error = 0.01;    ///< of distances; too long or too short, as the seed has it
  double heading_noise = 0.02;  ///< deg, standard deviation after a metre; a random walk
};

struct WheelReading {
  Stamp stamp;
  Pose T_odom_base;
  Tangent velocity_base = Tangent::Zero();  ///< [m/s; rad/s], ahead and about the vertical axis
};

/// The poses that wheels count from the start of the route until `end`.
std::vector<WheelReading> simulateWheels(const Route& route, Stamp end, const WheelConfig& config);

/// Of a usual MEMS unit.
struct ImuConfig {
  std::uint64_t seed = 1;
  double rate = 200.0;               ///< Hz
  double gyro_noise = 0.014;         ///< deg/s/sqrt(Hz)
  double gyro_bias = 0.5;            ///< deg/s, standard deviation on each axis
  double gyro_bias_walk = 0.005;     ///< deg/s/sqrt(s)
  double acceleration_noise = 2e-3;  ///< m/s^2/sqrt(Hz)
  double acceleration_bias = 0.05;   ///< m/s^2, standard deviation on each axis
  Pose T_base_imu;
};

struct ImuSample {
  Stamp stamp;
  Eigen::Vector3d turn_rate_imu = Eigen::Vector3d::Zero();     ///< rad/s
  Eigen::Vector3d acceleration_imu = Eigen::Vector3d::Zero();  ///< m/s^2, +g upwards at rest
};

std::vector<ImuSample> simulateImu(const Route& route, Stamp end, const ImuConfig& config);

}  // namespace revisit_slam::simulation
