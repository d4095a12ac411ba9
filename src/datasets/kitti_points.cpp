// SPDX-License-Identifier: MIT
#include "kitti_points.h"

#include <Eigen/Core>
#include <cmath>
#include <cstring>

#include "record_cloud.h"

namespace revisit_slam {
namespace {

/// Turns each point towards the sensor's z axis.
void raise(PointCloud& cloud, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t i = 0; i < cloud.width; ++i) {
    std::uint8_t* data = cloud.data.data() + i * cloud.point_step;
    Eigen::Vector3f p;
    std::memcpy(p.data(), data, sizeof(p));
    const double level = std::hypot(p.x(), p.y());
    if (!(level > 0.0)) continue;
    const double shrink = (c * level - s * p.z()) / level;
    p = {static_cast<float>(shrink * p.x()), static_cast<float>(shrink * p.y()),
         static_cast<float>(c * p.z() + s * level)};
    std::memcpy(data, p.data(), sizeof(p));
  }
}

}  // namespace

PointCloud readKittiPoints(const std::string& path, const DatasetOptions& options) {
  constexpr double missing_elevation = 0.205 * 3.14159265358979323846 / 180.0;
  PointCloud cloud = readRecords(path, xyzAndIntensity());
  if (options.correct_kitti_elevation) raise(cloud, missing_elevation);
  return cloud;
}

}  // namespace revisit_slam
