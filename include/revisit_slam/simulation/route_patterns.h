// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/simulation/layout.h"
#include "revisit_slam/simulation/polyline.h"
#include "revisit_slam/simulation/route_config.h"

namespace revisit_slam::simulation {

/// The middle of the way that a named route takes, and the streets that it belongs to.
struct RoutePattern {
  Layout layout;
  Polyline middle;
  /// Length of the first lap, metres, after which a lateral route changes its lane.
  double lap = 0.0;
};

/// Corners are sharp here; smoothing with `cornerSigma` rounds them.
/// @throw ParameterError where the length is too short for the revisits that the name promises, or
/// the world does not have the route.
RoutePattern makePattern(const RouteConfig& config);

/// Width of the smoothing that rounds the corners of a world's routes, metres.
double cornerSigma(WorldKind kind);

}  // namespace revisit_slam::simulation
