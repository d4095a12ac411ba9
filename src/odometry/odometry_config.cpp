// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/odometry_config.h"

#include "revisit_slam/util/number_list.h"

namespace revisit_slam {

Eigen::AlignedBox3f OdometryConfig::bodyBox() const {
  const std::vector<double> numbers = numbersOf(
      body, 6, "odometry/body", "two corners x y z x y z (m) in the base frame, or empty");
  Eigen::AlignedBox3f box;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    box.extend(Eigen::Vector3d(numbers[i], numbers[i + 1], numbers[i + 2]).cast<float>());
  return box;
}

}  // namespace revisit_slam
