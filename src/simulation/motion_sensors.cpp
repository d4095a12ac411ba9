// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/motion_sensors.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/simulation/random.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kGravity = 9.81;  // m/s^2

/// A number for each sample of each kind; wheels and IMU of one seed are unrelated.
Eigen::Vector3d noiseOf(std::uint64_t seed, std::uint64_t kind, std::uint64_t index) {
  Eigen::Vector3d noise;
  for (std::uint64_t axis = 0; axis < 3; ++axis)
    noise[static_cast<Eigen::Index>(axis)] = gaussianFrom(hashOf(seed, kind, index, axis));
  return noise;
}

enum Kind : std::uint64_t { kWheels = 9000, kGyro, kGyroBias, kGyroWalk, kForce, kForceBias };

std::size_t samplesUntil(Stamp start, Stamp end, double rate) {
  return static_cast<std::size_t>(std::max(0.0, secondsBetween(start, end) * rate)) + 1;
}

}  // namespace

std::vector<WheelReading> simulateWheels(const Route& route, Stamp end, const WheelConfig& config) {
  const bool too_long = hashOf(config.seed, kWheels, 0) % 2 == 0;
  const double scale = 1.0 + (too_long ? config.scale_error : -config.scale_error);
  std::vector<WheelReading> readings(1);
  readings.front().stamp = route.start();
  Pose T_map_before = route.poseAt(route.start());
  for (std::size_t i = 1; i < samplesUntil(route.start(), end, config.rate); ++i) {
    WheelReading reading;
    reading.stamp = route.start().plusSeconds(static_cast<double>(i) / config.rate);
    const Pose T_map_base = route.poseAt(reading.stamp);
    const Tangent moved = log(T_map_before.inverse() * T_map_base);
    Tangent counted = Tangent::Zero();
    counted[0] = scale * moved[0];
    counted[5] = moved[5] + kDegree * config.heading_noise * std::sqrt(std::abs(moved[0])) *
                                noiseOf(config.seed, kWheels, i).x();
    reading.T_odom_base = boxplus(readings.back().T_odom_base, counted);
    reading.velocity_base = config.rate * counted;
    readings.push_back(reading);
    T_map_before = T_map_base;
  }
  return readings;
}

std::vector<ImuSample> simulateImu(const Route& route, Stamp end, const ImuConfig& config) {
  const double step = 1.0 / config.rate;
  const Eigen::Vector3d force_bias = config.acceleration_bias * noiseOf(config.seed, kForceBias, 0);
  Eigen::Vector3d gyro_bias = kDegree * config.gyro_bias * noiseOf(config.seed, kGyroBias, 0);
  std::vector<ImuSample> samples(samplesUntil(route.start(), end, config.rate));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ImuSample& sample = samples[i];
    sample.stamp = route.start().plusSeconds(static_cast<double>(i) * step);
    const auto poseAt = [&](double seconds) {
      return route.poseAt(sample.stamp.plusSeconds(seconds)) * config.T_base_imu;
    };
    const Pose T_map_imu = poseAt(0.0), T_map_before = poseAt(-0.5 * step),
               T_map_after = poseAt(0.5 * step);
    const Eigen::Vector3d turned = logSO3(T_map_before.rotation.conjugate() * T_map_after.rotation);
    const Eigen::Vector3d acceleration_map =
        (T_map_after.translation - 2.0 * T_map_imu.translation + T_map_before.translation) /
        (0.25 * step * step);
    gyro_bias +=
        kDegree * config.gyro_bias_walk * std::sqrt(step) * noiseOf(config.seed, kGyroWalk, i);
    sample.turn_rate_imu =
        turned / step + gyro_bias +
        kDegree * config.gyro_noise * std::sqrt(config.rate) * noiseOf(config.seed, kGyro, i);
    sample.acceleration_imu =
        T_map_imu.rotation.conjugate() * (acceleration_map + Eigen::Vector3d(0.0, 0.0, kGravity)) +
        force_bias +
        config.acceleration_noise * std::sqrt(config.rate) * noiseOf(config.seed, kForce, i);
  }
  return samples;
}

}  // namespace revisit_slam::simulation
