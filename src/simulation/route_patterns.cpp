// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/route_patterns.h"

#include <algorithm>
#include <cmath>

#include "equal_rows.h"
#include "grid_walks.h"
#include "ramp_shape.h"
#include "revisit_slam/simulation/random.h"
#include "revisit_slam/util/parameters.h"
#include "storeys.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kPi = 3.141592653589793;

struct BlockSize {
  double usual;
  double smallest;
};

BlockSize blockSize(WorldKind kind) {
  switch (kind) {
    case WorldKind::kBridge:
      return {75.0, 75.0};
    case WorldKind::kField:
      return {70.0, 30.0};
    case WorldKind::kCampus:
      return {42.0, 20.0};
    case WorldKind::kCorridor:
      return {22.0, 10.0};
    default:
      return {90.0, 40.0};
  }
}

void requireOffered(const RouteConfig& config) {
  const bool offered = config.route == "tour" ||
                       (config.world == WorldKind::kMotorway && config.route == "loop") ||
                       (config.world == WorldKind::kBridge
                            ? config.route == "loop" || config.route == "out-and-back"
                            : !hasLevels(config.world) && !hasEqualRows(config.world) &&
                                  config.world != WorldKind::kMotorway);
  if (!offered) {
    throw ParameterError("route = '" + config.route + "': the world " + nameOf(config.world) +
                         " offers tour" +
                         (config.world == WorldKind::kBridge     ? ", loop and out-and-back"
                          : config.world == WorldKind::kMotorway ? " and loop"
                                                                 : ""));
  }
}

Polyline throughNodes(const StreetGrid& grid, const std::vector<GridNode>& nodes) {
  Polyline line;
  for (const GridNode node : nodes) {
    const Eigen::Vector2d p = grid.position(node);
    line.emplace_back(p.x(), p.y(), 0.0);
  }
  return line;
}

/// Ahead, around a turning circle and back on the same way.
Polyline withReturn(const Polyline& ahead, double radius) {
  const Eigen::Vector2d along = directionAt(ahead, ahead.size() - 1);
  const Eigen::Vector2d left(-along.y(), along.x());
  const Eigen::Vector2d centre = ahead.back().head<2>() + 1.5 * radius * along;
  Polyline line = ahead;
  for (double angle = -0.77 * kPi; angle < 0.78 * kPi; angle += 0.07 * kPi) {
    const Eigen::Vector2d p = centre + radius * (std::cos(angle) * along + std::sin(angle) * left);
    line.emplace_back(p.x(), p.y(), 0.0);
  }
  line.insert(line.end(), ahead.rbegin(), ahead.rend());
  return line;
}

RoutePattern outAndBack(const RouteConfig& config, Layout layout) {
  const double radius = 2.2 * cornerSigma(config.world);
  const double half = 0.5 * (config.length - 5.0 * radius);
  if (half < 20.0) {
    throw ParameterError("length = " + std::to_string(config.length) +
                         ": too short to drive out and back");
  }
  layout.bridge_length = std::max(120.0, half - 2.0 * layout.block);
  std::vector<GridNode> nodes{{-1, 0}};
  for (int i = 0; i <= static_cast<int>(1.2 * half / layout.block) + 2; ++i)
    nodes.push_back({i, 0});
  const Polyline street = resampled(throughNodes(StreetGrid(layout), nodes), 1.0);
  return {layout, withReturn(shortened(street, half), radius), config.length};
}

Polyline throughEqualPlaces(const RouteConfig& config) {
  if (config.world == WorldKind::kStoreys) return throughStoreys(config.length);
  return alongRows(equalRows(config.world, config.seed), config.length);
}

/// A ring of wide bends; three quarters of the drive are the first lap.
RoutePattern motorwayRing(const RouteConfig& config, const Layout& layout) {
  constexpr double kSmallest = 250.0;
  const double lap = config.length / 1.3, radius = std::max(kSmallest, 0.5 * lap / kPi);
  Random random(hashOf(config.seed, 905));
  const double phase = random.uniform(0.0, 2.0 * kPi), turned = random.uniform(0.0, 2.0 * kPi);
  Polyline line;
  double driven = 0.0;
  for (double angle = 0.0; line.empty() || driven < 1.1 * config.length + 20.0; angle += 0.002) {
    const double r = radius * (1.0 + 0.08 * std::cos(2.0 * angle + phase) +
                               0.015 * std::cos(5.0 * angle + 2.0 * phase));
    line.emplace_back(r * std::cos(angle + turned), r * std::sin(angle + turned), 0.0);
    driven = radius * angle;
  }
  return {layout, line, 2.0 * kPi * radius};
}

}  // namespace

double cornerSigma(WorldKind kind) {
  switch (kind) {
    case WorldKind::kCampus:
      return 1.2;
    case WorldKind::kCorridor:
      return 0.7;
    case WorldKind::kRamp:
      return 3.0;
    case WorldKind::kField:
    case WorldKind::kMotorway:
      return 6.0;
    case WorldKind::kAisles:
    case WorldKind::kStoreys:
      return 1.3;
    case WorldKind::kPortals:
      return 2.0;
    default:
      return 4.0;
  }
}

RoutePattern makePattern(const RouteConfig& config) {
  requireOffered(config);
  const BlockSize size = blockSize(config.world);
  Layout layout{config.world, config.seed, size.usual,
                std::clamp(0.3 * config.length, 120.0, 1500.0), true};
  if (config.world == WorldKind::kRamp) {
    return {layout, rampRoute(rampShape(config.length), config.length), config.length};
  }
  if (config.world == WorldKind::kMotorway) return motorwayRing(config, layout);
  if (config.world == WorldKind::kStoreys || hasEqualRows(config.world)) {
    layout.has_streets = false;
    return {layout, throughEqualPlaces(config), config.length};
  }
  if (config.route == "out-and-back") return outAndBack(config, layout);
  const GridWalk walk = makeWalk(config, size.usual);
  layout.block = walk.block;
  if (walk.block < size.smallest) {
    const double shortest = std::ceil(config.length * size.smallest / walk.block);
    throw ParameterError("length = " + std::to_string(config.length) + ": the route " +
                         config.route + " in the world " + nameOf(config.world) +
                         " needs at least " + std::to_string(shortest) + " m");
  }
  const Polyline walked = throughNodes(StreetGrid(layout), walk.nodes);
  if (!walk.closed) return {layout, walked, config.length};
  Polyline line = walked;
  while (arcLengths(line).back() < 1.1 * config.length + 20.0) {
    line.insert(line.end(), walked.begin() + 1, walked.end());
  }
  return {layout, line, arcLengths(walked).back()};
}

}  // namespace revisit_slam::simulation
