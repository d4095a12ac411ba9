// SPDX-License-Identifier: MIT
#include "roads.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/simulation/random.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kSpacing = 1.0;
constexpr double kStubSpacing = 70.0;

void addStreet(std::vector<Road>& roads, const StreetGrid& grid, GridNode a, GridNode b,
               const Neighbourhood& near, double half_width) {
  const Eigen::Vector2d from = grid.position(a), to = grid.position(b);
  Polyline line = resampled({{from.x(), from.y(), 0.0}, {to.x(), to.y(), 0.0}}, kSpacing);
  const bool seen = std::any_of(line.begin(), line.end(), [&](const Eigen::Vector3d& p) {
    return near.contains(p.head<2>());
  });
  if (seen) roads.push_back({line, half_width});
}

void addGridStreets(std::vector<Road>& roads, const Route& route, const Neighbourhood& near) {
  const Layout& layout = route.layout();
  const StreetGrid grid(layout);
  const auto index = [&](double x) { return static_cast<int>(std::floor(x / layout.block)); };
  const double width = roadHalfWidth(layout.kind);
  for (int i = index(near.low().x()) - 2; i <= index(near.high().x()) + 2; ++i) {
    for (int j = index(near.low().y()) - 2; j <= index(near.high().y()) + 2; ++j) {
      const GridNode node{i, j};
      if (grid.hasStreetAlongI(node)) addStreet(roads, grid, node, {i + 1, j}, near, width);
      if (grid.hasStreetAlongJ(node)) addStreet(roads, grid, node, {i, j + 1}, near, width);
    }
  }
}

/// Side streets of a recorded route, so that its walls have gaps.
void addSideStreets(std::vector<Road>& roads, const Route& route) {
  RoadIndex main_road;
  main_road.add(roads.front().middle, 0.0);
  Random random(hashOf(route.layout().seed, 920));
  const Polyline middle = roads.front().middle;
  for (double arc = 30.0; arc + 30.0 < route.length();
       arc += kStubSpacing * random.uniform(0.6, 1.6)) {
    const auto k = static_cast<std::size_t>(arc / Route::kStep);
    if (k >= middle.size()) break;
    const Eigen::Vector2d along = directionAt(middle, k);
    const Eigen::Vector2d aside = random.sign() * Eigen::Vector2d(-along.y(), along.x());
    Polyline line;
    for (double d = 0.0; d < random.uniform(60.0, 110.0); d += kSpacing) {
      const Eigen::Vector2d p = middle[k].head<2>() + d * aside;
      if (d > 12.0 && main_road.distance(p) < 11.0) break;
      line.emplace_back(p.x(), p.y(), 0.0);
    }
    if (line.size() > 35) roads.push_back({line, 3.8});
  }
}

bool hasGridStreets(const Layout& layout) {
  return layout.has_streets &&
         (layout.kind == WorldKind::kTown || layout.kind == WorldKind::kBridge ||
          layout.kind == WorldKind::kCampus);
}

}  // namespace

Neighbourhood::Neighbourhood(const Polyline& path) : low_(path[0].head<2>()), high_(low_) {
  for (const auto& p : path) {
    low_ = low_.cwiseMin(p.head<2>());
    high_ = high_.cwiseMax(p.head<2>());
  }
  low_.array() -= kWorldReach;
  high_.array() += kWorldReach;
  constexpr double kCell = 8.0;
  columns_ = static_cast<long>((high_.x() - low_.x()) / kCell) + 1;
  const long rows = static_cast<long>((high_.y() - low_.y()) / kCell) + 1;
  near_.assign(static_cast<std::size_t>(columns_ * rows), 0);
  const long reach = static_cast<long>(kWorldReach / kCell);
  for (std::size_t k = 0; k < path.size(); k += 8) {
    const long ci = static_cast<long>((path[k].x() - low_.x()) / kCell);
    const long cj = static_cast<long>((path[k].y() - low_.y()) / kCell);
    for (long j = std::max(0L, cj - reach); j <= std::min(rows - 1, cj + reach); ++j) {
      for (long i = std::max(0L, ci - reach); i <= std::min(columns_ - 1, ci + reach); ++i) {
        const bool inside = (i - ci) * (i - ci) + (j - cj) * (j - cj) <= reach * reach;
        if (inside) near_[static_cast<std::size_t>(j * columns_ + i)] = 1;
      }
    }
  }
}

bool Neighbourhood::contains(const Eigen::Vector2d& p) const {
  if ((p.array() < low_.array()).any() || (p.array() >= high_.array()).any()) return false;
  const long i = static_cast<long>((p.x() - low_.x()) / 8.0);
  const long j = static_cast<long>((p.y() - low_.y()) / 8.0);
  return near_[static_cast<std::size_t>(j * columns_ + i)] != 0;
}

std::vector<Road> makeRoads(const Route& route) {
  const Layout& layout = route.layout();
  const bool own_lane = laneOffset(layout.kind) > 1.0;
  const double half_width = roadHalfWidth(layout.kind);
  std::vector<Road> roads;
  if (!layout.has_streets) {
    const double offset = -laneOffset(layout.kind);
    roads.push_back({movedRight(route.path(), [=](double) { return offset; }), half_width});
    addSideStreets(roads, route);
    return roads;
  }
  if (layout.kind == WorldKind::kMotorway) {
    const double offset = -laneOffset(layout.kind);
    return {{movedRight(route.path(), [=](double) { return offset; }), half_width}};
  }
  roads.push_back({route.path(), own_lane ? half_width - 2.0 : half_width});
  if (hasGridStreets(layout)) addGridStreets(roads, route, Neighbourhood(route.path()));
  return roads;
}

}  // namespace revisit_slam::simulation
