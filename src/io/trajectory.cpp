// SPDX-License-Identifier: MIT
#include "revisit_slam/io/trajectory.h"

#include <Eigen/SVD>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& path) {
  throw std::runtime_error(what + " '" + path + "'");
}

/// Decimal seconds to nanoseconds, digit by digit: a double has no room for nanoseconds since 1970.
std::optional<Stamp> parseStamp(const std::string& text) {
  static const std::regex decimal(
      "([+-]?)([0-9]{1,9}|[1-3][0-9]{9}|4[0-2][0-9]{8})(?:\\.([0-9]*))?");
  constexpr std::size_t longest = 64;  // std::regex takes a piece of the stack for every letter
  std::smatch parts;
  if (text.size() > longest) return std::nullopt;
  if (std::regex_match(text, parts, decimal)) {
    std::string fraction = parts[3].str().substr(0, 9);
    fraction.resize(9, '0');
    const std::int64_t nanoseconds = std::stoll(parts[2]) * 1'000'000'000 + std::stoll(fraction);
    return Stamp{parts[1] == "-" ? -nanoseconds : nanoseconds};
  }
  char* end = nullptr;
  const double seconds = std::strtod(text.c_str(), &end);  // "1.7e9"
  if (end == text.c_str() || *end != '\0' || !(std::abs(seconds) < 4.3e9)) return std::nullopt;
  return Stamp::fromSeconds(seconds);
}

/// A line of a TUM file, if it is one.
std::optional<StampedPose> parseTumLine(const std::string& line) {
  std::istringstream fields(line);
  std::string stamp_text;
  StampedPose pose;
  auto& [q, t] = pose.T_world_base;
  if (!(fields >> stamp_text >> t.x() >> t.y() >> t.z() >> q.x() >> q.y() >> q.z() >> q.w()))
    return std::nullopt;
  const std::optional<Stamp> stamp = parseStamp(stamp_text);
  if (!stamp || !t.allFinite() || !std::isfinite(q.norm()) || q.norm() == 0.0) return std::nullopt;
  pose.stamp = *stamp;
  q.normalize();
  return pose;
}

/// A line of a KITTI file, if it is one.
std::optional<Pose> parseKittiLine(const std::string& line) {
  std::istringstream fields(line);
  Eigen::Matrix<double, 3, 4> T;
  for (int i = 0; i < 12; ++i)
    if (!(fields >> T(i / 4, i % 4))) return std::nullopt;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(T.leftCols<3>(),
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d R = svd.matrixU() * svd.matrixV().transpose();
  if (!T.allFinite() || svd.singularValues()(2) < 0.5 || R.determinant() < 0.0) return std::nullopt;
  return Pose{Eigen::Quaterniond(R).normalized(), T.col(3)};
}

bool isEmptyOrComment(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#';
}

}  // namespace

std::string stampText(Stamp stamp) {
  const std::int64_t nanoseconds = std::llabs(stamp.nanoseconds);
  char text[32];
  std::snprintf(text, sizeof(text), "%s%lld.%09lld", stamp.nanoseconds < 0 ? "-" : "",
                static_cast<long long>(nanoseconds / 1'000'000'000),
                static_cast<long long>(nanoseconds % 1'000'000'000));
  return text;
}

void writeTumLine(std::ostream& out, const StampedPose& pose) {
  const Eigen::Vector3d& t = pose.T_world_base.translation;
  const Eigen::Quaterniond& q = pose.T_world_base.rotation;
  char numbers[256];
  std::snprintf(numbers, sizeof(numbers), " %.9f %.9f %.9f %.12f %.12f %.12f %.12f\n", t.x(), t.y(),
                t.z(), q.x(), q.y(), q.z(), q.w());
  out << stampText(pose.stamp) << numbers;
}

Trajectory readTum(const std::string& path) {
  std::ifstream file(path);
  if (!file) fail("cannot read the trajectory", path);
  Trajectory trajectory;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (isEmptyOrComment(line)) continue;
    const std::optional<StampedPose> pose = parseTumLine(line);
    if (!pose)
      fail("line " + std::to_string(number) + " is not a stamp, a position and a quaternion in",
           path);
    trajectory.push_back(*pose);
  }
  return trajectory;
}

void writeTum(const std::string& path, const Trajectory& trajectory) {
  std::ostringstream text;
  for (const StampedPose& pose : trajectory) writeTumLine(text, pose);
  writeWholeText(path, text.str());
}

void writeKitti(const std::string& path, const Trajectory& trajectory) {
  std::ostringstream text;
  for (const StampedPose& pose : trajectory) {
    const Eigen::Matrix4d T = pose.T_world_base.matrix();
    char line[512];
    std::snprintf(line, sizeof(line),
                  "%.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g\n",
                  T(0, 0), T(0, 1), T(0, 2), T(0, 3), T(1, 0), T(1, 1), T(1, 2), T(1, 3), T(2, 0),
                  T(2, 1), T(2, 2), T(2, 3));
    text << line;
  }
  writeWholeText(path, text.str());
}

std::vector<Pose> readKitti(const std::string& path) {
  std::ifstream file(path);
  if (!file) fail("cannot read the trajectory", path);
  std::vector<Pose> poses;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (isEmptyOrComment(line)) continue;
    const std::optional<Pose> pose = parseKittiLine(line);
    if (!pose) fail("line " + std::to_string(number) + " is not a rigid 3x4 matrix in", path);
    poses.push_back(*pose);
  }
  return poses;
}

}  // namespace revisit_slam
