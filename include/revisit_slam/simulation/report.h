// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "revisit_slam/simulation/revisits.h"
#include "revisit_slam/simulation/route.h"

namespace revisit_slam::simulation {

/// Writes T_map_base in TUM format at 100 Hz from the start of the route to the last of `stamps`,
/// and at each of `stamps` exactly; sorted, no instant twice.
/// @throw std::runtime_error naming the file that cannot be written.
void writeTruth(const std::string& path, const Route& route, const std::vector<Stamp>& stamps);

/// What a drive consisted of.
struct DriveReport {
  /// Names and values of all options; values are JSON (numbers, true, quoted text).
  std::vector<std::pair<std::string, std::string>> options;
  int scans = 0;
  std::uint64_t points = 0;
  /// Metres that were driven in these scans.
  double length = 0.0;
  std::size_t triangles = 0;
  std::size_t moving_cars = 0;
  std::size_t people = 0;
  Stamp start;
  Stamp end;
  std::vector<Revisit> revisits;
};

/// Writes the report as JSON; instants in nanoseconds.
/// @throw std::runtime_error naming the file that cannot be written.
void writeReport(const std::string& path, const DriveReport& report);

/// `text` as a JSON string with its quotes.
std::string quoted(const std::string& text);

}  // namespace revisit_slam::simulation
