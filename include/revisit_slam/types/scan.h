// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// Points in metres; float keeps them to 8 micrometres at 100 m, as the drivers deliver them.
using Points = std::vector<Eigen::Vector3f>;

/// Where points were seen from that follow one another in a scan.
struct ScanView {
  Pose T_base_sensor;
  std::size_t end = 0;  ///< behind the last of them
};

/// One sweep of the sensor, as measured: not deskewed, every point finite and not the origin.
struct Scan {
  /// The instant at which the pose of this scan will be valid: that of its last point where point
  /// times are known, else the header stamp.
  Stamp stamp;
  /// In the sensor's frame, in the order of the message.
  Points points;
  /// Seconds from `stamp` for each point, none positive; empty where the times are not known, and
  /// then the scan is not deskewed.
  std::vector<float> times;
  /// The sensor on the robot.
  Pose T_base_sensor;
  /// Of a sweep of several sensors: the points of one after those of another, each in the frame of
  /// its own. Empty: all are of the sensor above.
  std::vector<ScanView> views;
  /// Of each point, in the sensor's own unit; empty where it has none.
  std::vector<float> intensities = {};
};

}  // namespace revisit_slam
