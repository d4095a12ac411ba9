// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/seen_through.h"

#include <cmath>

namespace revisit_slam {
namespace {

constexpr std::size_t kMostRays = 500;
// In voxels:
constexpr double kFree = 2.0;  // at both ends of a ray, where nothing counts
constexpr double kStep = 0.5;
constexpr double kBesideStep = 0.6;  // from a step to the nearest map point
constexpr double kBesideRay = 0.3;   // from where the ray meets the plane to the map point on it
/// Cosine between ray and normal. What is met at a smaller angle may as well be passed.
constexpr double kFacing = 0.4;

/// Whether the ray meets the plane between its ends, and beside the map point.
bool meets(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double last,
           const Neighbour& neighbour, double beside) {
  if (neighbour.shape.kind != ShapeKind::planar) return false;
  const Eigen::Vector3d normal = neighbour.shape.normal.cast<double>();
  const double facing = normal.dot(direction);
  if (std::abs(facing) < kFacing) return false;
  const double way = normal.dot(neighbour.point_odom - origin) / facing;
  return way < last && (origin + way * direction - neighbour.point_odom).norm() < beside;
}

}  // namespace

double shareSeenThrough(const Points& points_base, const Eigen::Vector3d& sensor_base,
                        const Pose& T_odom_base, const LocalVoxelMap& map) {
  const double edge = map.voxelSize();
  const Eigen::Vector3d origin = T_odom_base * sensor_base;
  const std::size_t stride = points_base.size() / kMostRays + 1;
  std::size_t rays = 0, through = 0;
  for (std::size_t i = 0; i < points_base.size(); i += stride) {
    const Eigen::Vector3d ray =
        T_odom_base * Eigen::Vector3d(points_base[i].cast<double>()) - origin;
    const Eigen::Vector3d direction = ray.normalized();
    const double last = ray.norm() - kFree * edge;
    if (last < kFree * edge) continue;
    ++rays;
    bool is_through = false;
    Neighbour neighbour;
    for (double way = kFree * edge; way < last && !is_through; way += kStep * edge)
      is_through = map.nearest(origin + way * direction, kBesideStep * edge, neighbour) &&
                   meets(origin, direction, last, neighbour, kBesideRay * edge);
    through += is_through ? 1 : 0;
  }
  return rays > 0 ? static_cast<double>(through) / static_cast<double>(rays) : 0.0;
}

}  // namespace revisit_slam
