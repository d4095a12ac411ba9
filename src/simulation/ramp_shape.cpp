// SPDX-License-Identifier: MIT
#include "ramp_shape.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam::simulation {
namespace {

constexpr double kPi = 3.141592653589793;
constexpr int kPointsPerTurn = 90;

/// Counter-clockwise from the lowest y; the slope begins and ends gently.
Polyline helix(const RampShape& shape, double radius) {
  Polyline line;
  const int count = shape.turns * kPointsPerTurn;
  for (int k = 0; k <= count; ++k) {
    const double part = static_cast<double>(k) / count;
    const double angle = -0.5 * kPi + 2.0 * kPi * shape.turns * part;
    const double ease = part - 0.35 * std::sin(2.0 * kPi * part) / (2.0 * kPi);
    line.emplace_back(shape.centre.x() + radius * std::cos(angle),
                      shape.centre.y() + radius * std::sin(angle), shape.deckHeight() * ease);
  }
  return line;
}

void append(Polyline& line, const Polyline& more) {
  line.insert(line.end(), more.begin(), more.end());
}

Polyline roundTheDeck(const RampShape& shape) {
  const double h = shape.deckHeight();
  const double back = shape.centre.y() - shape.down_radius;
  return {{60.0, 0.0, h}, {80.0, 0.0, h}, {80.0, 46.0, h}, {36.0, 46.0, h}, {36.0, back, h}};
}

Polyline belowTheDeck() {
  return {{-60.0, -5.5, 0.0},  {-80.0, -5.5, 0.0}, {-80.0, -24.0, 0.0},
          {100.0, -24.0, 0.0}, {100.0, 44.0, 0.0}, {60.0, 46.0, 0.0},
          {-40.0, 46.0, 0.0},  {-60.0, 30.0, 0.0}, {-60.0, 4.0, 0.0}};
}

}  // namespace

RampShape rampShape(double length) {
  RampShape shape;
  shape.turns = std::clamp(static_cast<int>(length / 500.0), 1, 3);
  return shape;
}

Polyline wayUp(const RampShape& shape) {
  Polyline line{{-50.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}};
  append(line, helix(shape, shape.up_radius));
  line.emplace_back(shape.deck_low.x() + 1.0, 0.0, shape.deckHeight());
  return line;
}

Polyline wayDown(const RampShape& shape) {
  const double y = shape.centre.y() - shape.down_radius;
  Polyline line = helix(shape, shape.down_radius);
  line.insert(line.begin(), Eigen::Vector3d(-50.0, y, 0.0));
  line.emplace_back(shape.deck_low.x() + 1.0, y, shape.deckHeight());
  std::reverse(line.begin(), line.end());
  return line;
}

Polyline rampRoute(const RampShape& shape, double length) {
  Polyline line;
  while (line.empty() || arcLengths(line).back() < 1.05 * length + 20.0) {
    append(line, belowTheDeck());
    append(line, wayUp(shape));
    append(line, roundTheDeck(shape));
    append(line, wayDown(shape));
  }
  return line;
}

}  // namespace revisit_slam::simulation
