// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/relative_error.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace revisit_slam {
namespace {

constexpr std::size_t kStep = 10;

/// Way along the reference to each pose, metres.
std::vector<double> waysAlong(const Trajectory& reference) {
  std::vector<double> ways(reference.size(), 0.0);
  for (std::size_t i = 1; i < reference.size(); ++i)
    ways[i] =
        ways[i - 1] +
        (reference[i].T_world_base.translation - reference[i - 1].T_world_base.translation).norm();
  return ways;
}

std::optional<std::size_t> endOfSubsequence(const std::vector<double>& ways, std::size_t first,
                                            double length) {
  const auto begin = ways.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = std::upper_bound(begin, ways.end(), *begin + length);
  if (end == ways.end()) return std::nullopt;
  return static_cast<std::size_t>(end - ways.begin());
}

Pose motion(const Trajectory& trajectory, std::size_t first, std::size_t last) {
  return trajectory[first].T_world_base.inverse() * trajectory[last].T_world_base;
}

}  // namespace

RelativeError relativeError(const TrajectoryMatch& match) {
  RelativeError result;
  const std::vector<double> ways = waysAlong(match.reference);
  double translation = 0.0, rotation = 0.0;
  for (std::size_t first = 0; first < ways.size(); first += kStep)
    for (const double length : kSubsequenceLengths) {
      const std::optional<std::size_t> last = endOfSubsequence(ways, first, length);
      if (!last) break;
      const Pose error =
          motion(match.estimate, first, *last).inverse() * motion(match.reference, first, *last);
      result.subsequences.push_back(
          {first, length, error.translation.norm() / length, error.angle() / length});
      translation += result.subsequences.back().translation;
      rotation += result.subsequences.back().rotation;
    }
  const auto count = static_cast<double>(result.subsequences.size());  // 0 / 0 is NaN
  result.translation_percent = 100.0 * translation / count;
  result.rotation_deg_per_m = 180.0 / M_PI * rotation / count;
  return result;
}

}  // namespace revisit_slam
