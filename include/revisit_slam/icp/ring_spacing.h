// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// The direction across the rings of the sensor at a point.
struct AcrossRings {
  Eigen::Vector3d direction_base = Eigen::Vector3d::UnitZ();
  /// From 0 to 1: what share of a squared residual in this direction depends on where rings fell.
  double unknown = 0.0;
};

/// How far apart the rings of a sensor are, as one scan shows it: at which elevations about the z
/// axis of the sensor it has points, and at which it has none.
class RingSpacing {
 public:
  /// No rings.
  RingSpacing() = default;
  RingSpacing(const Points& points_sensor, const Pose& T_base_sensor);

  /// Difference of the sines of elevation from a ring to the next; 0 where rings cannot be told
  /// apart. `sine`: of the elevation.
  double gap(double sine) const { return gaps_.empty() ? 0.0 : gaps_[bin(sine)]; }

  /// `resolution`: m, rings that are nearer to each other than this leave nothing unknown.
  AcrossRings at(const Eigen::Vector3d& p_base, double resolution) const;

 private:
  static std::size_t bin(double sine);

  Eigen::Vector3d sensor_base_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_base_ = Eigen::Vector3d::UnitZ();
  std::vector<float> gaps_;  // of each bin of the sine of the elevation; empty without rings
};

}  // namespace revisit_slam
