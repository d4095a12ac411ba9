// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Errors of an odometry: a scale that is constant, and where messages do not tell, those of the
/// odometry motion model (Thrun et al., Probabilistic Robotics, Sec. 5.4): standard deviations that
/// grow with what was travelled.
struct OdometryNoiseConfig {
  double initial_scale_error = 0.02;
  double scale_walk = 2e-5;
  double translation_per_metre = 0.005;
  double slip_per_metre = 0.004;
  double translation_per_radian = 0.05;
  double rotation_per_metre = 0.002;
  double rotation_per_radian = 0.03;
  double error_scans = 50.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("initial_scale_error", initial_scale_error, Range{0.0, 1.0}, "",
      "standard deviation of the scale at the start: 0.02 where a metre may be measured as 0.98 m. "
      "Raise it if the diameter of the wheels is not known; lower it if they are calibrated");
    v("scale_walk", scale_walk, Range{0.0, 0.1}, "1/sqrt(m)",
      "random walk of the scale, as its standard deviation after 1 m. Raise it if load and tyre "
      "pressure change; lower it if the scale is noisy");
    v("translation_per_metre", translation_per_metre, Range{1e-4, 1.0}, "",
      "standard deviation along the motion, in metres for each metre travelled, beside that of the "
      "scale; for messages without a covariance. Raise it if wheels slip; lower it if the pose "
      "drifts in the direction of motion where little is in view");
    v("slip_per_metre", slip_per_metre, Range{1e-4, 1.0}, "",
      "standard deviation across the motion, in metres for each metre travelled; for messages "
      "without a covariance. Raise it for tracks and on loose ground; lower it if traffic in bends "
      "moves the pose aside");
    v("translation_per_radian", translation_per_radian, Range{0.0, 10.0}, "m/rad",
      "standard deviation of the position, in metres for each radian turned; for messages without "
      "a covariance. Raise it if wheels skid in turns; lower it if the pose slips in turns");
    v("rotation_per_metre", rotation_per_metre, Range{1e-5, 1.0}, "rad/m",
      "standard deviation of the rotation, in radians for each metre travelled; for messages "
      "without a covariance. Raise it if wheels are worn unequally; lower it if the heading drifts "
      "in bare surroundings");
    v("rotation_per_radian", rotation_per_radian, Range{0.0, 1.0}, "",
      "standard deviation of the rotation, in radians for each radian turned; for messages without "
      "a covariance. Raise it if wheels skid in turns; lower it if the heading slips in turns");
    v("error_scans", error_scans, Range{1.0, 1e4}, "scans",
      "number of scans over which an error of the registration stays the same, as that of matches "
      "with cars that drive along: beside this odometry the weight of a registration is divided by "
      "it. Raise it if traffic drags the pose along; lower it if wheels slip for seconds");
  }
};

struct GyroNoiseConfig {
  double noise_density = 5e-4;
  double initial_bias = 0.02;
  double bias_walk = 1e-4;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("noise_density", noise_density, Range{1e-7, 1.0}, "rad/s/sqrt(Hz)",
      "noise of the turn rates, where messages have no covariance. Raise it if vibrations disturb "
      "the gyro; lower it to the value of its data sheet");
    v("initial_bias", initial_bias, Range{0.0, 1.0}, "rad/s",
      "standard deviation of the bias at the start, on each axis. Raise it if the gyro is rejected "
      "at the start; lower it if the gyro is calibrated");
    v("bias_walk", bias_walk, Range{0.0, 0.1}, "rad/s/sqrt(s)",
      "random walk of the bias, as its standard deviation after 1 s. Raise it if the gyro warms "
      "up; lower it if the bias is noisy");
  }
};

/// Motion that is measured outside: wheels, an inertial unit. Off where no topic is named.
struct PriorsConfig {
  std::string odometry_topic;
  std::string odometry_frame;
  std::string imu_topic;
  double max_wait = 0.5;
  double max_gap = 0.25;
  double gate = 4.0;
  OdometryNoiseConfig odometry;
  GyroNoiseConfig gyro;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("odometry_topic", odometry_topic, Choices{}, "",
      "topic of an odometry of the robot, nav_msgs/Odometry, live and in bags; empty: none");
    v("odometry_frame", odometry_frame, Choices{}, "",
      "name of a frame in which the base frame is moved by TF, as by an odometry of the robot; "
      "instead of odometry_topic; empty: none");
    v("imu_topic", imu_topic, Choices{}, "",
      "topic of an IMU, sensor_msgs/Imu, live and in bags; empty: none");
    v("max_wait", max_wait, Range{0.0, 10.0}, "s",
      "longest time, by stamps of later scans, for which a scan waits for messages of odometry and "
      "IMU; then it is registered without them. Raise it if messages come late; lower it if poses "
      "come too late");
    v("max_gap", max_gap, Range{0.001, 10.0}, "s",
      "longest time between two messages over which is interpolated. Raise it for slow topics; "
      "lower it if messages get lost in fast motion");
    v("gate", gate, Range{1.0, 100.0}, "",
      "number of standard deviations by which measured and predicted motion may differ; beyond it "
      "the measured motion is rejected. Raise it if good measurements are rejected; lower it if "
      "slipping wheels pull the pose");
    v.group("odometry", odometry);
    v.group("gyro", gyro);
  }
};

}  // namespace revisit_slam
