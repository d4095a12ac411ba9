// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "revisit_slam/simulation/mesh.h"
#include "revisit_slam/simulation/route.h"
#include "roads.h"
#include "shapes.h"

namespace revisit_slam::simulation {

/// A rectangle on the ground, turned by the placement's yaw about its centre.
struct Plot {
  Placement centre;
  double half_length = 1.0;
  double half_width = 1.0;
};

bool overlap(const Plot& a, const Plot& b);

/// What is being built: the roads, what stands already, and the mesh that grows.
class Site {
 public:
  explicit Site(const Route& route);

  /// Height of the ground surface with kerbs and roughness, metres.
  double ground(const Eigen::Vector2d& p) const;
  /// Metres beyond the nearest road's edge.
  double fromRoad(const Eigen::Vector2d& p) const { return edges_.distance(p); }
  /// Metres from the line that the platform's base drives.
  double fromRoute(const Eigen::Vector2d& p) const { return driven_.distance(p); }
  bool isNear(const Eigen::Vector2d& p) const { return near_.contains(p); }

  /// Whether the plot keeps `clearance` metres from all roads and is free of other plots.
  bool isFree(const Plot& plot, double clearance) const;
  void occupy(const Plot& plot);

  const Route& route() const { return route_; }
  const Layout& layout() const { return route_.layout(); }
  const std::vector<Road>& roads() const { return roads_; }
  const Neighbourhood& neighbourhood() const { return near_; }
  TriangleMesh& mesh() { return mesh_; }

 private:
  bool touchesOther(const Plot& plot) const;

  const Route& route_;
  std::vector<Road> roads_;
  RoadIndex edges_;
  RoadIndex driven_;
  Neighbourhood near_;
  std::unordered_map<std::uint64_t, std::vector<Plot>> plots_;
  TriangleMesh mesh_;
};

}  // namespace revisit_slam::simulation
