// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "roads.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kCellSize = 4.0;

std::uint64_t keyOf(long i, long j) {
  return (static_cast<std::uint64_t>(i) << 32) ^ (static_cast<std::uint64_t>(j) & 0xFFFFFFFFULL);
}

}  // namespace

void RoadIndex::add(const Polyline& middle, double half_width) {
  for (const auto& p : middle) {
    const long i = static_cast<long>(std::floor(p.x() / kCellSize));
    const long j = static_cast<long>(std::floor(p.y() / kCellSize));
    cells_[keyOf(i, j)].push_back({p.head<2>().cast<float>(), static_cast<float>(half_width)});
  }
}

double RoadIndex::distance(const Eigen::Vector2d& p) const {
  const long ci = static_cast<long>(std::floor(p.x() / kCellSize));
  const long cj = static_cast<long>(std::floor(p.y() / kCellSize));
  constexpr long kRings = static_cast<long>(kReach / kCellSize);
  constexpr double kWidest = 10.0;
  double nearest = kReach;
  for (long ring = 0; ring <= kRings; ++ring) {
    if (static_cast<double>(ring - 1) * kCellSize - kWidest > nearest) break;
    for (long j = -ring; j <= ring; ++j) {
      const long step = std::abs(j) == ring ? 1 : std::max(1L, 2 * ring);
      for (long i = -ring; i <= ring; i += step) {
        const auto cell = cells_.find(keyOf(ci + i, cj + j));
        if (cell == cells_.end()) continue;
        for (const Sample& sample : cell->second) {
          const double distance = (sample.position.cast<double>() - p).norm();
          nearest = std::min(nearest, distance - static_cast<double>(sample.half_width));
        }
      }
    }
  }
  return nearest;
}

}  // namespace revisit_slam::simulation
