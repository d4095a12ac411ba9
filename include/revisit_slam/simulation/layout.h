// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace revisit_slam::simulation {

enum class WorldKind {
  kTown,
  kBridge,
  kField,
  kCampus,
  kRamp,
  kCorridor,
  kMotorway,
  kBays,
  kTerraces,
  kAisles,
  kPortals,
  kStoreys
};

/// The names as the command line has them, in the order of the enumeration.
const std::vector<std::string>& worldNames();
/// @throw ParameterError for a name that is none of worldNames().
WorldKind worldKindOf(const std::string& name);
std::string nameOf(WorldKind kind);

/// What the route and the world have to agree about before either exists.
struct Layout {
  WorldKind kind = WorldKind::kTown;
  std::uint64_t seed = 1;
  /// Mean distance of neighbouring crossings, metres.
  double block = 90.0;
  /// Length of the street from node (0, 0) to node (1, 0) in a bridge world, metres.
  double bridge_length = 300.0;
  /// False where a file gives the route: then the only roads are those that it drives.
  bool has_streets = true;
};

/// A crossing of the street grid.
struct GridNode {
  int i = 0;
  int j = 0;
};

/// The crossings of an endless, slightly irregular street grid, each a function of its indices.
class StreetGrid {
 public:
  explicit StreetGrid(const Layout& layout) : layout_(layout) {}

  /// In the map frame, metres; (0, 0) is near the origin.
  Eigen::Vector2d position(GridNode node) const;
  /// Whether the street from the node to its neighbour at +i (or +j) exists.
  bool hasStreetAlongI(GridNode node) const;
  bool hasStreetAlongJ(GridNode node) const;
  bool isBridge(GridNode a, GridNode b) const;

 private:
  double jitter(int a, int b, std::uint64_t purpose) const;

  Layout layout_;
};

/// Whether levels lie above each other, so that the route has heights of its own.
bool hasLevels(WorldKind kind);
/// Whether the ground is level and smooth.
bool isPaved(WorldKind kind);
/// Half the width of the carriageway of a street, metres.
double roadHalfWidth(WorldKind kind);
/// How far right of the middle of the road the vehicle keeps, metres.
double laneOffset(WorldKind kind);

}  // namespace revisit_slam::simulation
