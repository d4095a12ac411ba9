// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/speed_profile.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/simulation/random.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kStep = 0.05;
constexpr double kSmoothing = 0.3;
constexpr double kFirstWait = 0.5;
constexpr double kSlowest = 0.6;

double curvatureAt(const Polyline& path, std::size_t i, double step) {
  const std::size_t reach = static_cast<std::size_t>(std::max(1.0, 1.0 / step));
  if (i < reach || i + reach >= path.size()) return 0.0;
  const Eigen::Vector3d bend = path[i - reach] - 2.0 * path[i] + path[i + reach];
  return bend.head<2>().norm() / std::pow(static_cast<double>(reach) * step, 2);
}

std::vector<double> speedLimits(const Polyline& path, double step, const SpeedLimits& limits) {
  std::vector<double> speeds(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double bound =
        std::sqrt(limits.lateral_acceleration / (curvatureAt(path, i, step) + 1e-9));
    speeds[i] = std::max(std::min(kSlowest, limits.speed), std::min(limits.speed, bound));
  }
  return speeds;
}

/// The samples at which the vehicle stands for a while.
std::vector<std::size_t> stops(std::size_t count, double step, const SpeedLimits& limits) {
  std::vector<std::size_t> result;
  if (limits.stop_distance <= 0.0) return result;
  Random random(hashOf(limits.seed, 910));
  double arc = 0.0;
  while (true) {
    arc += limits.stop_distance * random.uniform(0.5, 1.5);
    const auto index = static_cast<std::size_t>(arc / step);
    if (index + 2 >= count) return result;
    result.push_back(index);
  }
}

void limitAcceleration(std::vector<double>& speeds, double step, double acceleration) {
  const auto reachable = [&](double from) {
    return std::sqrt(from * from + 2.0 * acceleration * step);
  };
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    speeds[i] = std::min(speeds[i], reachable(speeds[i - 1]));
  }
  for (std::size_t i = speeds.size() - 1; i > 0; --i) {
    speeds[i - 1] = std::min(speeds[i - 1], reachable(speeds[i]));
  }
}

}  // namespace

SpeedProfile profileThrough(const std::vector<double>& times, const std::vector<double>& arcs) {
  Polyline samples;
  std::size_t i = 0;
  for (double time = 0.0; time <= times.back(); time += kStep) {
    while (i + 2 < times.size() && times[i + 1] <= time) ++i;
    const double u =
        std::clamp((time - times[i]) / std::max(times[i + 1] - times[i], 1e-9), 0.0, 1.0);
    samples.emplace_back(arcs[i] + u * (arcs[i + 1] - arcs[i]), 0.0, 0.0);
  }
  std::vector<SpeedProfile::Value> controls;
  for (const auto& sample : smoothed(samples, kSmoothing / kStep)) {
    controls.emplace_back(std::clamp(sample.x(), 0.0, arcs.back()));
  }
  return {controls, kStep};
}

SpeedProfile makeSpeedProfile(const Polyline& path, double step, const SpeedLimits& limits) {
  std::vector<double> speeds = speedLimits(path, step, limits);
  const std::vector<std::size_t> stop_indices = stops(path.size(), step, limits);
  for (const std::size_t i : stop_indices) speeds[i] = 0.0;
  speeds.front() = speeds.back() = 0.0;
  limitAcceleration(speeds, step, limits.acceleration);
  std::vector<double> times{0.0, kFirstWait}, arcs{0.0, 0.0};
  Random random(hashOf(limits.seed, 911));
  std::size_t stop = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    times.push_back(times.back() + 2.0 * step / (speeds[i - 1] + speeds[i]));
    arcs.push_back(step * static_cast<double>(i));
    if (stop < stop_indices.size() && stop_indices[stop] == i) {
      times.push_back(times.back() + random.uniform(2.0, 8.0));
      arcs.push_back(arcs.back());
      ++stop;
    }
  }
  return profileThrough(times, arcs);
}

}  // namespace revisit_slam::simulation
