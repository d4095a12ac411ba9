// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "revisit_slam/types/registered_scan.h"

namespace revisit_slam {

/// Finds a sensor that is mounted askew or upside down and whose transform says otherwise: its
/// ground is tilted in the base frame from the first scan on, on whatever slope the robot stands,
/// or above it. Grid and map would be askew with it.
class TiltCheck {
 public:
  /// The next scan of the session. @return a warning with its remedy, once, or an empty text.
  std::string take(const RegisteredScan& scan);

 private:
  std::vector<Eigen::Vector3d> up_base_;  // normals of the ground in the first scans
  std::size_t upside_down_ = 0;           // of these
};

}  // namespace revisit_slam
