// SPDX-License-Identifier: MIT
#include "site.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "revisit_slam/simulation/random.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kCell = 32.0;
constexpr double kKerbHeight = 0.12;

std::uint64_t keyAt(const Eigen::Vector2d& p, long di, long dj) {
  const long i = static_cast<long>(std::floor(p.x() / kCell)) + di;
  const long j = static_cast<long>(std::floor(p.y() / kCell)) + dj;
  return (static_cast<std::uint64_t>(i) << 32) ^ (static_cast<std::uint64_t>(j) & 0xFFFFFFFFULL);
}

std::array<Eigen::Vector2d, 4> cornersOf(const Plot& plot) {
  const double l = plot.half_length, w = plot.half_width;
  return {plot.centre.flat(-l, -w), plot.centre.flat(l, -w), plot.centre.flat(l, w),
          plot.centre.flat(-l, w)};
}

/// Whether a side of `a` separates the two.
bool separates(const Plot& a, const Plot& b) {
  for (const bool along : {true, false}) {
    const double yaw = a.centre.yaw + (along ? 0.0 : 1.5707963267948966);
    const Eigen::Vector2d axis(std::cos(yaw), std::sin(yaw));
    const double half = along ? a.half_length : a.half_width;
    const double middle = axis.dot(a.centre.origin.head<2>());
    double low = 1e300, high = -1e300;
    for (const auto& corner : cornersOf(b)) {
      low = std::min(low, axis.dot(corner));
      high = std::max(high, axis.dot(corner));
    }
    if (low > middle + half || high < middle - half) return true;
  }
  return false;
}

bool hasKerbs(WorldKind kind) {
  return kind == WorldKind::kTown || kind == WorldKind::kBridge;
}

}  // namespace

bool overlap(const Plot& a, const Plot& b) {
  return !separates(a, b) && !separates(b, a);
}

Site::Site(const Route& route) : route_(route), roads_(makeRoads(route)), near_(route.path()) {
  for (const Road& road : roads_) edges_.add(road.middle, road.half_width);
  driven_.add(route.path(), 0.0);
}

double Site::ground(const Eigen::Vector2d& p) const {
  const double outside = fromRoad(p);
  const double kerb =
      hasKerbs(layout().kind) ? kKerbHeight * std::clamp(outside / 0.5, 0.0, 1.0) : 0.0;
  const bool paved = isPaved(layout().kind);
  const double rough = paved ? 0.003 : 0.006 + 0.03 * std::clamp((outside - 1.5) / 2.0, 0.0, 1.0);
  const double grain = smoothNoise(layout().seed + 7200, p.x() / 0.9, p.y() / 0.9);
  const double lumps = paved ? 0.0 : smoothNoise(layout().seed + 7300, p.x() / 6.0, p.y() / 6.0);
  return route_.terrain().height(p) + kerb + rough * (grain + 2.0 * lumps);
}

bool Site::touchesOther(const Plot& plot) const {
  for (long i = -1; i <= 1; ++i) {
    for (long j = -1; j <= 1; ++j) {
      const auto cell = plots_.find(keyAt(plot.centre.origin.head<2>(), i, j));
      if (cell == plots_.end()) continue;
      for (const Plot& other : cell->second) {
        if (overlap(plot, other)) return true;
      }
    }
  }
  return false;
}

bool Site::isFree(const Plot& plot, double clearance) const {
  if (!isNear(plot.centre.origin.head<2>())) return false;
  const int nl = static_cast<int>(plot.half_length) + 1, nw = static_cast<int>(plot.half_width) + 1;
  for (int a = 0; a <= nl; ++a) {
    for (int b = 0; b <= nw; ++b) {
      const Eigen::Vector2d p = plot.centre.flat(plot.half_length * (2.0 * a / nl - 1.0),
                                                 plot.half_width * (2.0 * b / nw - 1.0));
      if (fromRoad(p) < clearance || route_.terrain().isWater(p.x(), p.y())) return false;
    }
  }
  return !touchesOther(plot);
}

void Site::occupy(const Plot& plot) {
  plots_[keyAt(plot.centre.origin.head<2>(), 0, 0)].push_back(plot);
}

}  // namespace revisit_slam::simulation
