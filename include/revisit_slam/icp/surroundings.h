// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "revisit_slam/geometry/point_moments.h"

namespace revisit_slam {

/// How the map points around a place lie, which says what a distance to the nearest of them means.
enum class Spread : std::uint8_t {
  /// Few, or along a line that is not upright: perhaps a single ring of the sensor on a surface that
  /// is not known between its rings. The ring moves along with the sensor; the distance to it says
  /// little.
  sparse,
  planar,     ///< the distance to the plane counts, the one within it depends on where rays fell
  scattered,  ///< in several directions, or on a pole: edges, trunks, foliage
};

struct Surroundings {
  Spread spread = Spread::sparse;
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< of the plane, else zero
  float points = 0.0f;  ///< number of map points looked at
};

/// `around`: of the points in a voxel and the 26 around it, `edge` its length in metres; z is up.
Surroundings surroundingsOf(const PointMoments& around, float edge);

}  // namespace revisit_slam
