// SPDX-License-Identifier: MIT
#include "revisit_slam/io/trajectory.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace revisit_slam {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& path) {
  throw std::runtime_error(what + " '" + path + "'");
}

/// Decimal seconds to nanoseconds, digit by digit: a double has no room for nanoseconds since 1970.
Stamp parseStamp(const std::string& text) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos || text.find_first_of("eE") != std::string::npos)
    return Stamp::fromSeconds(std::stod(text));
  std::string fraction = text.substr(point + 1, 9);
  fraction.resize(9, '0');
  const std::int64_t seconds = std::stoll(text.substr(0, point));
  const std::int64_t nanoseconds = std::stoll(fraction);
  const bool negative = text.front() == '-';
  return {seconds * 1'000'000'000 + (negative ? -nanoseconds : nanoseconds)};
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
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    std::string stamp;
    StampedPose pose;
    auto& [q, t] = pose.T_world_base;
    if (!(fields >> stamp >> t.x() >> t.y() >> t.z() >> q.x() >> q.y() >> q.z() >> q.w()))
      fail("line " + std::to_string(number) + " has no stamp and seven numbers in", path);
    pose.stamp = parseStamp(stamp);
    q.normalize();
    trajectory.push_back(pose);
  }
  return trajectory;
}

void writeKitti(const std::string& path, const Trajectory& trajectory) {
  std::ofstream file(path);
  for (const StampedPose& pose : trajectory) {
    const Eigen::Matrix4d T = pose.T_world_base.matrix();
    char line[512];
    std::snprintf(line, sizeof(line),
                  "%.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g\n",
                  T(0, 0), T(0, 1), T(0, 2), T(0, 3), T(1, 0), T(1, 1), T(1, 2), T(1, 3), T(2, 0),
                  T(2, 1), T(2, 2), T(2, 3));
    file << line;
  }
  if (!file.flush()) fail("cannot write the trajectory", path);
}

TumWriter::TumWriter(const std::string& path) : path_(path), file_(path) {
  if (!file_) fail("cannot write the trajectory", path);
}

void TumWriter::write(const StampedPose& pose) {
  writeTumLine(file_, pose);
  if (!file_.flush()) fail("cannot write the trajectory", path_);
}

}  // namespace revisit_slam
