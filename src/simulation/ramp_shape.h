// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/simulation/polyline.h"

namespace revisit_slam::simulation {

/// A parking deck: the road passes below the upper deck, climbs a helix, goes around on the deck
/// and returns by a wider helix beside the first. The levels lie above each other in xy. Metres.
struct RampShape {
  int turns = 2;
  double rise_per_turn = 3.6;
  Eigen::Vector2d centre{0.0, 14.0};
  double up_radius = 14.0;
  double down_radius = 19.5;
  /// The upper deck covers these ranges.
  Eigen::Vector2d deck_low{20.0, -14.0};
  Eigen::Vector2d deck_high{92.0, 58.0};

  double deckHeight() const { return turns * rise_per_turn; }
};

/// As many turns as suit a route of this length.
RampShape rampShape(double length);

/// The ways up and down with the straights that join them to the deck; heights are road surfaces.
Polyline wayUp(const RampShape& shape);
Polyline wayDown(const RampShape& shape);

/// Laps through the whole building until `length` is reached.
Polyline rampRoute(const RampShape& shape, double length);

}  // namespace revisit_slam::simulation
