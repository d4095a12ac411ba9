// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace revisit_slam::simulation {

/// Points in the map frame, metres.
using Polyline = std::vector<Eigen::Vector3d>;

/// Distance in the xy plane from the first point to each point.
std::vector<double> arcLengths(const Polyline& line);

/// Points every `step` metres along the line (in xy), beginning at its first.
Polyline resampled(const Polyline& line, double step);

/// Gaussian smoothing along the index that leaves both ends where they are.
Polyline smoothed(const Polyline& line, double sigma_in_points);

/// Unit vector in xy along the line at a point; to its right is (y, -x).
Eigen::Vector2d directionAt(const Polyline& line, std::size_t index);

/// The line moved to its right by `offset(arc length)` metres.
Polyline movedRight(const Polyline& line, const std::function<double(double)>& offset);

/// What lies within `length` metres from the first point.
Polyline shortened(const Polyline& line, double length);

}  // namespace revisit_slam::simulation
