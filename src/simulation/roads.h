// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "revisit_slam/simulation/polyline.h"
#include "revisit_slam/simulation/route.h"

namespace revisit_slam::simulation {

/// The middle of a carriageway every metre and half its width, metres.
struct Road {
  Polyline middle;
  double half_width = 5.0;
};

/// Answers how far a place is from the edge of the nearest road.
class RoadIndex {
 public:
  void add(const Polyline& middle, double half_width);
  /// Metres from the nearest road's edge, negative on the road, at most kReach.
  double distance(const Eigen::Vector2d& p) const;

  static constexpr double kReach = 24.0;

 private:
  struct Sample {
    Eigen::Vector2f position;
    float half_width;
  };
  using Cell = std::vector<Sample>;

  std::unordered_map<std::uint64_t, Cell> cells_;
};

/// The route's own road first, then the streets near it.
std::vector<Road> makeRoads(const Route& route);

/// How far from the route the world is built, metres.
constexpr double kWorldReach = 125.0;

/// Tells whether a place is within kWorldReach of the route.
class Neighbourhood {
 public:
  explicit Neighbourhood(const Polyline& path);
  bool contains(const Eigen::Vector2d& p) const;
  const Eigen::Vector2d& low() const { return low_; }
  const Eigen::Vector2d& high() const { return high_; }

 private:
  Eigen::Vector2d low_;
  Eigen::Vector2d high_;
  long columns_ = 0;
  std::vector<char> near_;
};

}  // namespace revisit_slam::simulation
