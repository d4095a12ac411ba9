// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/mover.h"

namespace revisit_slam::simulation {

Pose Mover::poseAt(Stamp stamp) const {
  const Eigen::Matrix<double, 6, 1> state = motion.value(secondsBetween(from, stamp));
  Eigen::Matrix3d axes;
  axes.col(0) = state.tail<3>().normalized();
  axes.col(1) = Eigen::Vector3d::UnitZ().cross(axes.col(0)).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return {Eigen::Quaterniond(axes), state.head<3>()};
}

}  // namespace revisit_slam::simulation
