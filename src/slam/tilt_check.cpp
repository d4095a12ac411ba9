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

double medianOf(const std::vector<Eigen::Vector3d>& vectors, int axis) {
  std::vector<double> values;
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

}  // namespace

std::string TiltCheck::take(const RegisteredScan& scan) {
  if (up_base_.size() == kScans) return "";
  const Eigen::Quaterniond R_level_base = levelOnGround(scan.points_base).rotation;
  up_base_.push_back(R_level_base.conjugate() * Eigen::Vector3d::UnitZ());
  if (up_base_.size() < kScans) return "";
  const Eigen::Vector3d up_base =
      Eigen::Vector3d(medianOf(up_base_, 0), medianOf(up_base_, 1), medianOf(up_base_, 2))
          .normalized();
  return std::acos(std::min(1.0, up_base.z())) > kLargest ? describe(up_base, scan.sensor_frame)
                                                          : "";
}

}  // namespace revisit_slam
