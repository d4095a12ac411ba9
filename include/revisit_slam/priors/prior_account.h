// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace revisit_slam {

/// What became of the messages of one sensor, and of the scans that it should have served.
struct PriorAccount {
  std::size_t received = 0;                    ///< messages
  std::map<std::string, std::size_t> dropped;  ///< messages, by reason
  std::size_t used = 0;                        ///< scans whose prediction it entered
  std::size_t rejected = 0;                    ///< scans where it disagreed beyond the gate
  std::size_t missing = 0;                     ///< scans for which it had no readings
  std::optional<double> scale;                 ///< of an odometry, as estimated so far
  std::optional<Eigen::Vector3d> bias;         ///< of a gyro, as estimated so far, rad/s
  bool is_silent = false;  ///< nothing that can be used came in time: scans do not wait for it
};

}  // namespace revisit_slam
