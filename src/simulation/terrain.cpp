// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/terrain.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/simulation/random.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kRiverDepth = 14.0;
constexpr double kWaterDepth = 11.0;
constexpr double kBankWidth = 35.0;

struct Hills {
  double height;
  double size;
};

Hills hillsOf(WorldKind kind) {
  switch (kind) {
    case WorldKind::kTown:
      return {3.5, 170.0};
    case WorldKind::kField:
      return {3.0, 120.0};
    case WorldKind::kCampus:
      return {1.5, 60.0};
    case WorldKind::kBridge:
      return {1.5, 180.0};
    case WorldKind::kMotorway:
      return {4.0, 500.0};
    default:
      return {0.0, 100.0};
  }
}

double smoothStep(double t) {
  const double u = std::clamp(t, 0.0, 1.0);
  return u * u * u * (u * (6.0 * u - 15.0) + 10.0);
}

}  // namespace

double Terrain::roadHeight(double x, double y) const {
  if (measured_) return measured_->height(x, y);
  const Hills hills = hillsOf(layout_.kind);
  return hills.height * layeredNoise(layout_.seed + 7000, x / hills.size, y / hills.size, 2);
}

double Terrain::riverDepth(double x, double y) const {
  if (layout_.kind != WorldKind::kBridge || !layout_.has_streets) return 0.0;
  const StreetGrid grid(layout_);
  const double wobble = 12.0 * smoothNoise(layout_.seed + 7100, y / 50.0, 0.5);
  const double from = grid.position({0, 0}).x() + 40.0 + wobble;
  const double to = grid.position({1, 0}).x() - 40.0 + wobble;
  return kRiverDepth * smoothStep((x - from) / kBankWidth) * smoothStep((to - x) / kBankWidth);
}

double Terrain::height(double x, double y) const {
  return roadHeight(x, y) - riverDepth(x, y);
}

bool Terrain::isWater(double x, double y) const {
  return riverDepth(x, y) > kWaterDepth;
}

}  // namespace revisit_slam::simulation
