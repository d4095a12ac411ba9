// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/layout.h"

#include <algorithm>

#include "equal_rows.h"
#include "revisit_slam/simulation/random.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kLineJitter = 0.18;
constexpr double kNodeJitter = 0.05;

}  // namespace

const std::vector<std::string>& worldNames() {
  static const std::vector<std::string> names{"town",     "bridge",   "field",    "campus",
                                              "ramp",     "corridor", "motorway", "bays",
                                              "terraces", "aisles",   "portals",  "storeys"};
  return names;
}

WorldKind worldKindOf(const std::string& name) {
  const auto& names = worldNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    std::string offered;
    for (const std::string& each : names) offered += (offered.empty() ? "" : ", ") + each;
    throw ParameterError("world = '" + name + "': must be one of " + offered);
  }
  return static_cast<WorldKind>(found - names.begin());
}

std::string nameOf(WorldKind kind) {
  return worldNames()[static_cast<std::size_t>(kind)];
}

double StreetGrid::jitter(int a, int b, std::uint64_t purpose) const {
  const auto first = static_cast<std::uint64_t>(static_cast<std::int64_t>(a));
  const auto second = static_cast<std::uint64_t>(static_cast<std::int64_t>(b));
  return layout_.block * (2.0 * unitFrom(hashOf(layout_.seed, first, second, purpose)) - 1.0);
}

Eigen::Vector2d StreetGrid::position(GridNode node) const {
  const double x = node.i * layout_.block + kLineJitter * jitter(node.i, 0, 101) +
                   kNodeJitter * jitter(node.i, node.j, 103);
  const double y = node.j * layout_.block + kLineJitter * jitter(node.j, 0, 102) +
                   kNodeJitter * jitter(node.i, node.j, 104);
  const bool across = layout_.kind == WorldKind::kBridge && node.i >= 1;
  return {across ? x - layout_.block + layout_.bridge_length : x, y};
}

bool StreetGrid::hasStreetAlongI(GridNode node) const {
  return layout_.kind != WorldKind::kBridge || node.i != 0 || node.j == 0;
}

bool StreetGrid::hasStreetAlongJ(GridNode) const {
  return true;
}

bool StreetGrid::isBridge(GridNode a, GridNode b) const {
  return layout_.kind == WorldKind::kBridge && a.j == 0 && b.j == 0 && std::min(a.i, b.i) == 0 &&
         std::max(a.i, b.i) == 1;
}

bool hasLevels(WorldKind kind) {
  return kind == WorldKind::kRamp || kind == WorldKind::kStoreys;
}

bool isPaved(WorldKind kind) {
  return hasLevels(kind) || hasEqualRows(kind) || kind == WorldKind::kCorridor;
}

double roadHalfWidth(WorldKind kind) {
  switch (kind) {
    case WorldKind::kTown:
    case WorldKind::kBridge:
      return 5.5;
    case WorldKind::kRamp:
      return 5.0;
    case WorldKind::kMotorway:
      return 13.5;
    case WorldKind::kBays:
    case WorldKind::kTerraces:
    case WorldKind::kPortals:
      return 3.0;
    case WorldKind::kField:
      return 2.5;
    case WorldKind::kCampus:
    case WorldKind::kCorridor:
    case WorldKind::kAisles:
    case WorldKind::kStoreys:
      return 1.8;
  }
  return 5.5;
}

double laneOffset(WorldKind kind) {
  if (kind == WorldKind::kMotorway) return 6.5;  // the middle one of three lanes
  if (hasEqualRows(kind) || kind == WorldKind::kStoreys) return 0.0;
  return kind == WorldKind::kTown || kind == WorldKind::kBridge ? 1.75 : 0.4;
}

}  // namespace revisit_slam::simulation
