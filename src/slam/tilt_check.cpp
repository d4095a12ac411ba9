// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/tilt_check.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "revisit_slam/loops/recognition/ground_alignment.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kScans = 10;
constexpr double kLargest = 0.14;  // rad: kerbs and banks beside the robot stay below, mounts above
constexpr double kDegree = 0.017453292519943295;
constexpr double kNear = 15.0;           // m from the sensor: farther away the ground may bend
constexpr double kThickness = 0.3;       // m, of the ground, on both sides of its plane
constexpr double kLargestBelow = 0.05;   // share of the points near by: ground has few below it
constexpr double kSmallestBelow = 0.05;  // share that tells a ground below the sensor
constexpr double kSmallestAbove = 0.2;   // and one above: a ceiling over a floor is none

double medianOf(const std::vector<Eigen::Vector3d>& vectors, int axis) {
  std::vector<double> values;
  values.reserve(vectors.size());
  for (const Eigen::Vector3d& vector : vectors) values.push_back(vector[axis]);
  std::nth_element(values.begin(), values.begin() + kScans / 2, values.end());
  return values[kScans / 2];
}

/// Angles as static_transform_publisher takes them: up_base = (R_y(pitch) R_x(roll))^T e_z.
std::string describe(const Eigen::Vector3d& up_base, const std::string& frame) {
  const double roll = std::atan2(up_base.y(), up_base.z());
  const double pitch = std::asin(std::clamp(-up_base.x(), -1.0, 1.0));
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << "the ground is tilted by "
       << std::acos(std::clamp(up_base.z(), -1.0, 1.0)) / kDegree
       << " degrees in the base frame, and grid and map with it: if '" << frame
       << "' is mounted askew, broadcast its transform, with " << std::setprecision(2) << pitch
       << " rad of pitch and " << roll << " rad of roll more than now";
  return text.str();
}

/// As the sensor or, turned about x, one that hangs upside down would have them.
Points pointsNear(const RegisteredScan& scan, bool turned) {
  Points points;
  for (const Eigen::Vector3f& p : scan.points_base) {
    if ((p - scan.sensor_base.cast<float>()).head<2>().norm() > kNear) continue;
    points.push_back(turned ? Eigen::Vector3f(p.x(), -p.y(), -p.z()) : p);
  }
  return points;
}

/// The share of the points that lie on the plane that levels them; 0 where others lie below it, or
/// the sensor, of this height, does.
double shareOnGround(const Points& points, double sensor_height) {
  const Pose T_level_points = levelOnGround(points);
  std::size_t on = 0;
  std::size_t below = 0;
  for (const Eigen::Vector3f& point : points) {
    const double height = (T_level_points * point.cast<double>()).z();
    on += std::abs(height) < kThickness ? 1 : 0;
    below += height < -kThickness ? 1 : 0;
  }
  const auto share = [&](std::size_t some) {
    return static_cast<double>(some) / static_cast<double>(points.size());
  };
  const bool is_above = sensor_height + T_level_points.translation.z() > 0.0;
  return !points.empty() && is_above && share(below) < kLargestBelow ? share(on) : 0.0;
}

/// Whether the ground is above the sensor.
bool isUpsideDown(const RegisteredScan& scan) {
  const double height = scan.sensor_base.z();
  return shareOnGround(pointsNear(scan, false), height) < kSmallestBelow &&
         shareOnGround(pointsNear(scan, true), -height) > kSmallestAbove;
}

std::string describeUpsideDown(const std::string& frame) {
  return "the ground seems to be above '" + frame +
         "': if it hangs upside down, so do map and grid; then broadcast its transform, with 3.14 "
         "rad of roll more than now";
}

}  // namespace

std::string TiltCheck::take(const RegisteredScan& scan) {
  if (up_base_.size() == kScans) return "";
  const Eigen::Quaterniond R_level_base = levelOnGround(scan.points_base).rotation;
  up_base_.push_back(R_level_base.conjugate() * Eigen::Vector3d::UnitZ());
  upside_down_ += isUpsideDown(scan) ? 1 : 0;
  if (up_base_.size() < kScans) return "";
  if (upside_down_ > kScans / 2) return describeUpsideDown(scan.sensor_frame);
  const Eigen::Vector3d up_base =
      Eigen::Vector3d(medianOf(up_base_, 0), medianOf(up_base_, 1), medianOf(up_base_, 2))
          .normalized();
  return std::acos(std::min(1.0, up_base.z())) > kLargest ? describe(up_base, scan.sensor_frame)
                                                          : "";
}

}  // namespace revisit_slam
