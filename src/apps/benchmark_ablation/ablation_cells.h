// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// One combination of what the paper has and what there is beside it, and the parameters of it.
struct AblationCell {
  std::string odometry;     ///< paper, ours: with down-sampling, information and splitting of maps
  std::string information;  ///< sampled, identity
  std::string loops;        ///< paper, ours
  std::string retroactive;  ///< on, off
  std::string kernel;       ///< of backend/kernel
  double kernel_scale = 0.0;
  SlamConfig config;
};

/// All cells of one odometry.
std::vector<AblationCell> cellsOf(const std::string& odometry);

/// Those of the default with scales of the robust kernels between a tenth and a thousand times 1.
std::vector<AblationCell> kernelScalesOf(const std::string& odometry);

/// Up to the maps: no loops, no occupancy.
SlamConfig frontEndOf(const std::string& odometry);

}  // namespace revisit_slam
