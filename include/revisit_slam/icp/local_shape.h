// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "revisit_slam/geometry/point_moments.h"

namespace revisit_slam {

/// How the map points around a place are distributed: what a distance to the nearest of them means.
enum class ShapeKind : std::uint8_t {
  /// Too few, or along a line that is not upright: perhaps a single ring of the sensor on a surface
  /// that is not known between its rings. Rings move along with it; the distance to one says
  /// little.
  sparse,
  planar,     ///< the distance to the plane counts, the one within it depends on where rays fell
  scattered,  ///< in several directions, or on a pole: edges, trunks, foliage
};

/// The shape of the map around a point.
struct LocalShape {
  ShapeKind kind = ShapeKind::sparse;
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< of the plane, else zero
  float points = 0.0f;                               ///< number of map points looked at
  /// Few points, or along a line: a ring, a column of a spinning sensor on a wall, a pole. What
  /// they lie on shows farther around, if at all.
  bool is_line = true;
};

/// `around`: of the points in a voxel and the 26 around it, `edge` its length in metres; z is up.
LocalShape localShapeOf(const PointMoments& around, float edge);

/// What lies farther around is looked at in cubes of so many edges.
constexpr int kFartherEdges = 3;

/// Of points along a line, with what lies farther around: planar if that is a plane, as thin as a
/// tenth of an edge, and the points lie on it; else as `line` has it.
/// @param near, farther moments about the same origin, those of farther in the larger cubes.
LocalShape widenedShapeOf(const LocalShape& line, const PointMoments& near,
                          const PointMoments& farther, float edge);

}  // namespace revisit_slam
