// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Roll and pitch of the map by the accelerations of an inertial unit.
struct GravityConfig {
  bool enabled = true;
  double window = 4.0;
  double deviation = 0.002;
  double bias = 0.02;
  double kernel_scale = 4.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("enabled", enabled,
      "true: roll and pitch of the map follow the accelerations of the IMU, where "
      "priors/imu_topic names one that measures them; false: they do not");
    v("window", window, Range{0.5, 60.0}, "s",
      "time over which accelerations are averaged to a direction of gravity, which is that of the "
      "scan in the middle. Raise it if vibrations disturb the unit; lower it if the tilt drifts "
      "within the window");
    v("deviation", deviation, Range{1e-5, 1.0}, "rad",
      "standard deviation of a measured direction of gravity. Raise it if the map bends where the "
      "robot accelerates; lower it if heights drift");
    v("bias", bias, Range{1e-5, 1.0}, "rad",
      "standard deviation of the directions' constant error, by the bias of the accelerometer and "
      "by its transform. Raise it for a unit that is mounted by eye; lower it for a calibrated "
      "one");
    v("kernel_scale", kernel_scale, Range{0.1, 1000.0}, "",
      "scale of the robust kernel (geman_mcclure) of directions, in standard deviations. Raise it "
      "if good directions are outliers; lower it if shocks bend the map");
  }
};

}  // namespace revisit_slam
