// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "revisit_slam/input/scan_reading.h"

namespace revisit_slam {

/// The points from one index up to another, as a message of its own.
inline ScanReading partOf(const Scan& sweep, std::size_t begin, std::size_t end) {
  ScanReading part;
  part.frame_id = "lidar";
  part.counts.received = part.counts.kept = end - begin;
  Scan& scan = part.scan.emplace();
  const float last = sweep.times[end - 1];
  scan.stamp = sweep.stamp.plusSeconds(last);
  scan.T_base_sensor = sweep.T_base_sensor;
  for (std::size_t i = begin; i < end; ++i) {
    scan.points.push_back(sweep.points[i]);
    scan.times.push_back(sweep.times[i] - last);
  }
  part.header_stamp = scan.stamp.plusSeconds(scan.times.front());
  return part;
}

/// The messages of a sensor that sends a sweep, whose points are in the order of their times, in
/// `count` of them.
inline std::vector<ScanReading> partsOf(const Scan& sweep, std::size_t count) {
  std::vector<ScanReading> parts;
  const std::size_t points = sweep.points.size();
  for (std::size_t i = 0; i < count; ++i)
    parts.push_back(partOf(sweep, points * i / count, points * (i + 1) / count));
  return parts;
}

inline std::vector<ScanReading> partsOf(const std::vector<Scan>& sweeps, std::size_t count) {
  std::vector<ScanReading> parts;
  for (const Scan& sweep : sweeps)
    for (ScanReading& part : partsOf(sweep, count)) parts.push_back(std::move(part));
  return parts;
}

}  // namespace revisit_slam
