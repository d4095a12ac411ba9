// SPDX-License-Identifier: MIT
#include "kitti_oxts.h"

#include <cmath>
#include <cstdio>
#include <ctime>

#include "files.h"
#include "text_rows.h"

namespace revisit_slam {
namespace {

constexpr double pi = 3.14159265358979323846;

std::int64_t secondsSince1970(const TextRow& row, const std::string& clock) {
  std::tm date{};
  char end = 0;
  const bool parsed =
      std::sscanf(row.words[0].c_str(), "%4d-%2d-%2d%c", &date.tm_year, &date.tm_mon, &date.tm_mday,
                  &end) == 3 &&
      std::sscanf(clock.c_str(), "%2d:%2d%c", &date.tm_hour, &date.tm_min, &end) == 2;
  const bool possible = date.tm_year >= 1970 && date.tm_year < 2100 && date.tm_mon >= 1 &&
                        date.tm_mon <= 12 && date.tm_mday >= 1 && date.tm_mday <= 31 &&
                        date.tm_hour >= 0 && date.tm_hour < 24 && date.tm_min >= 0 &&
                        date.tm_min < 60;
  if (!parsed || !possible) row.fail("not a date and a time of day");
  date.tm_year -= 1900;
  date.tm_mon -= 1;
  return timegm(&date);
}

Stamp stampOf(const TextRow& row) {
  const std::size_t colon = row.words[1].rfind(':');
  if (colon == std::string::npos) row.fail("not a date and a time of day");
  const std::int64_t minute = secondsSince1970(row, row.words[1].substr(0, colon));
  const TextRow seconds{row.path, row.line, {row.words[1].substr(colon + 1)}};
  const Stamp after_minute = seconds.seconds(0);
  if (after_minute.toSeconds() > 61.0) row.fail("not a date and a time of day");
  return {minute * 1'000'000'000 + after_minute.nanoseconds};
}

/// East, north, up in metres; `scale` is the cosine of the first latitude.
Eigen::Vector3d positionOf(const TextRow& row, double scale) {
  constexpr double earth_radius = 6378137.0;  // m
  const double latitude = row.number(0), longitude = row.number(1);
  if (std::abs(latitude) > 89.0) row.fail("a latitude of " + row.words[0] + " degrees");
  if (std::abs(longitude) > 360.0) row.fail("a longitude of " + row.words[1] + " degrees");
  return {scale * earth_radius * longitude * pi / 180.0,
          scale * earth_radius * std::log(std::tan((90.0 + latitude) * pi / 360.0)), row.number(2)};
}

Eigen::Quaterniond rotationOf(const TextRow& row) {
  const double roll = row.number(3), pitch = row.number(4), yaw = row.number(5);
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

}  // namespace

std::map<std::size_t, Stamp> readKittiDates(const std::string& path) {
  std::map<std::size_t, Stamp> stamps;
  forEachRow(path, 2, [&](const TextRow& row) { stamps[row.line - 1] = stampOf(row); });
  return stamps;
}

Trajectory readOxts(const std::string& folder) {
  constexpr std::size_t columns = 30;
  const std::string date_file = requireBelow(folder, {"timestamps.txt"});
  const std::map<std::size_t, Stamp> stamps = readKittiDates(date_file);
  double scale = 0.0;
  Eigen::Vector3d origin;
  Trajectory poses;
  for (const NumberedFile& file : numberedFiles(requireBelow(folder, {"data"}), ".txt")) {
    const auto stamp = stamps.find(static_cast<std::size_t>(file.number));
    if (stamp == stamps.end())
      throw DatasetError(date_file, "has no stamp for " + std::to_string(file.number));
    forEachRow(file.path, columns, [&](const TextRow& row) {
      if (poses.empty()) {
        scale = std::cos(row.number(0) * pi / 180.0);
        origin = positionOf(row, scale);
      }
      poses.push_back({stamp->second, {rotationOf(row), positionOf(row, scale) - origin}});
    });
  }
  return poses;
}

}  // namespace revisit_slam
