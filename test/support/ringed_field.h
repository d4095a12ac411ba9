// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

#include "revisit_slam/types/scan.h"
#include "support/random_numbers.h"

namespace revisit_slam {

/// Flat open ground with a shed here and there, seen by a spinning sensor whose rings on the ground
/// move along with it.
class RingedField {
 public:
  RingedField() {
    RandomNumbers random(11);
    for (int i = 0; i < 60; ++i) {
      const Eigen::Vector3d foot(random.uniform(-40, 80), random.uniform(-40, 40), 0.0);
      if (std::abs(foot.y()) > 4.0)
        sheds_.emplace_back(foot, foot + Eigen::Vector3d(3.0, 2.0, 2.5));
    }
  }

  /// From `T_field_base` at once, without times. The sensor is 1.8 m above the base.
  Scan scan(Stamp stamp, const Pose& T_field_base, double noise, RandomNumbers& random) const {
    constexpr int columns = 512, rings = 32;
    Scan scan{stamp, {}, {}, {Eigen::Quaterniond::Identity(), {0.0, 0.0, kHeight}}, {}};
    const Pose T_field_sensor = T_field_base * scan.T_base_sensor;
    for (int column = 0; column < columns; ++column)
      for (int ring = 0; ring < rings; ++ring) {
        const double azimuth = 2.0 * M_PI * column / columns, rise = -0.4 + 0.014 * ring;
        const Eigen::Vector3d ray(std::cos(rise) * std::cos(azimuth),
                                  std::cos(rise) * std::sin(azimuth), std::sin(rise));
        const double range = rangeOf(T_field_sensor.translation, T_field_sensor.rotation * ray);
        if (range < 60.0)
          scan.points.push_back(((range + random.gaussian(noise)) * ray).cast<float>());
      }
    return scan;
  }

 private:
  using Box = Eigen::AlignedBox3d;
  static constexpr double kHeight = 1.8;

  double rangeOf(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray) const {
    double nearest = ray.z() < 0.0 ? -origin.z() / ray.z() : std::numeric_limits<double>::max();
    for (const Box& shed : sheds_) {
      const Eigen::Array3d a = (shed.min() - origin).array() / ray.array();
      const Eigen::Array3d b = (shed.max() - origin).array() / ray.array();
      const double enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
      if (enter > 0.0 && enter < leave) nearest = std::min(nearest, enter);
    }
    return nearest;
  }

  std::vector<Box> sheds_;
};

}  // namespace revisit_slam
