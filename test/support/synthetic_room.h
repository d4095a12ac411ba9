// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "revisit_slam/types/scan.h"
#include "revisit_slam/types/se3.h"
#include "support/random_numbers.h"

namespace revisit_slam {

/// A closed hall of 40 x 30 x 6 m with boxes in it; the odometry frame is in its middle.
class SyntheticRoom {
 public:
  /// Metres from `origin` along the unit vector `direction` to the first surface.
  double range(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
    double nearest = crossings(hall_, origin, direction).second;
    for (const Box& box : boxes_) {
      const auto [enter, leave] = crossings(box, origin, direction);
      if (enter > 0.0 && enter < leave) nearest = std::min(nearest, enter);
    }
    return nearest;
  }

  /// Points seen from `origin` in random directions, with noise along the ray.
  Points sample(const Eigen::Vector3d& origin, std::size_t count, double noise,
                RandomNumbers& random) const {
    Points points(count);
    for (auto& point : points) {
      const Eigen::Vector3d direction = random.direction();
      const double measured = range(origin, direction) + random.gaussian(noise);
      point = (origin + measured * direction).cast<float>();
    }
    return points;
  }

  /// A sweep of 0.1 s that ends at `T_room_base`, of a sensor that moves with `velocity` (body).
  /// Heights are random: rings on the floor would move along with the sensor and hold ICP back.
  Scan sweep(Stamp stamp, const Pose& T_room_base, const Tangent& velocity,
             const Pose& T_base_sensor, double noise, RandomNumbers& random) const {
    constexpr int columns = 360, rows = 16;
    Scan scan{stamp, {}, {}, T_base_sensor, {}};
    for (int column = 0; column < columns; ++column) {
      const double time = 0.1 * (column + 1 - columns) / columns;
      const Pose T_room_sensor = T_room_base * exp(time * velocity) * T_base_sensor;
      for (int row = 0; row < rows; ++row) {
        const double azimuth = 2.0 * M_PI * column / columns, rise = random.uniform(-0.4, 0.4);
        const Eigen::Vector3d direction(std::cos(rise) * std::cos(azimuth),
                                        std::cos(rise) * std::sin(azimuth), std::sin(rise));
        const double measured =
            range(T_room_sensor.translation, T_room_sensor.rotation * direction);
        scan.points.push_back(((measured + random.gaussian(noise)) * direction).cast<float>());
        scan.times.push_back(static_cast<float>(time));
      }
    }
    return scan;
  }

 private:
  using Box = Eigen::AlignedBox3d;

  /// Where the line enters and leaves the box.
  static std::pair<double, double> crossings(const Box& box, const Eigen::Vector3d& origin,
                                             const Eigen::Vector3d& direction) {
    const Eigen::Array3d a = (box.min() - origin).array() / direction.array();
    const Eigen::Array3d b = (box.max() - origin).array() / direction.array();
    return {a.min(b).maxCoeff(), a.max(b).minCoeff()};
  }

  Box hall_{Eigen::Vector3d(-20, -15, -2), Eigen::Vector3d(20, 15, 4)};
  std::vector<Box> boxes_{{Eigen::Vector3d(6, 3, -2), Eigen::Vector3d(9, 5, 1)},
                          {Eigen::Vector3d(-12, -9, -2), Eigen::Vector3d(-8, -7, 2.5)},
                          {Eigen::Vector3d(-6, 7, -2), Eigen::Vector3d(-5, 11, 0)},
                          {Eigen::Vector3d(13, -11, -2), Eigen::Vector3d(14, -6, 4)},
                          {Eigen::Vector3d(2, -13, 1), Eigen::Vector3d(8, -12, 3)}};
};

}  // namespace revisit_slam
