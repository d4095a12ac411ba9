// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "revisit_slam/simulation/layout.h"

namespace revisit_slam::simulation {

/// A smooth height over the plane that passes near given points and fills what lies between.
class HeightGrid {
 public:
  explicit HeightGrid(const std::vector<Eigen::Vector3d>& anchors);
  double height(double x, double y) const;

 private:
  double cell(long column, long row) const;

  Eigen::Vector2d origin_;
  Eigen::ArrayXXd heights_;
};

/// The shape of the land without roughness, kerbs and structures: twice continuously
/// differentiable. Metres in the map frame.
class Terrain {
 public:
  explicit Terrain(const Layout& layout) : layout_(layout) {}
  /// Land that follows a route with known heights.
  Terrain(const Layout& layout, const std::vector<Eigen::Vector3d>& route)
      : layout_(layout), measured_(HeightGrid(route)) {}

  double height(double x, double y) const;
  double height(const Eigen::Vector2d& p) const { return height(p.x(), p.y()); }
  /// Whether the place lies under the water below the bridge.
  bool isWater(double x, double y) const;
  /// Height of a road at this place: that of the land as if there were no river.
  double roadHeight(double x, double y) const;

 private:
  double riverDepth(double x, double y) const;

  Layout layout_;
  std::optional<HeightGrid> measured_;
};

}  // namespace revisit_slam::simulation
