// SPDX-License-Identifier: MIT
#include "echo.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/simulation/random.h"

namespace revisit_slam::simulation {
namespace {

/// Signal of a white surface, met at a right angle, relative to the detection threshold at 60 m.
constexpr double kSignal = 60.0;
constexpr double kReferenceRange = 60.0;
constexpr double kMirrorCosine = 0.9;
constexpr double kMirrorLoss = 0.55;

}  // namespace

bool isLost(const RayHit& hit, double random_dropout, std::uint64_t hash) {
  const double ratio = kReferenceRange / std::max(hit.range, 0.1);
  const double signal = kSignal * reflectivityOf(hit.material) * hit.cosine * ratio * ratio;
  double detected = (1.0 - std::exp(-signal)) * (1.0 - random_dropout);
  if (hit.material == Material::kGlass && hit.cosine < kMirrorCosine) detected *= 1.0 - kMirrorLoss;
  return unitFrom(hash) >= detected;
}

float intensityOf(const RayHit& hit, std::uint64_t hash) {
  const double spread = 1.0 + 0.08 * gaussianFrom(hash);
  const double value = 255.0 * reflectivityOf(hit.material) * std::sqrt(hit.cosine) * spread;
  return static_cast<float>(std::round(std::clamp(value, 0.0, 255.0)));
}

}  // namespace revisit_slam::simulation
