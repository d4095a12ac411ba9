// SPDX-License-Identifier: MIT
#include "revisit_slam/input/azimuth_times.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace revisit_slam {
namespace {

constexpr float pi = 3.14159265358979f;

/// atan2 to 4e-7 rad at a fraction of its cost: atan(q) = q P(q²) on [0, 1] with the minimax
/// polynomial P, and symmetry.
float fastAtan2(float y, float x) {
  const float abs_x = std::abs(x);
  const float abs_y = std::abs(y);
  const float larger = std::max(std::max(abs_x, abs_y), std::numeric_limits<float>::min());
  const float q = std::min(abs_x, abs_y) / larger;
  const float s = q * q;
  const float p =
      0.99999611f +
      s * (-0.33317368f +
           s * (0.19807815f +
                s * (-0.13233342f + s * (0.07962366f + s * (-0.03360421f + s * 0.00681179f)))));
  float angle = q * p;
  angle = abs_y > abs_x ? 0.5f * pi - angle : angle;
  angle = x < 0.f ? pi - angle : angle;
  return std::copysign(angle, y);
}

}  // namespace

std::vector<float> sweepFractions(const Points& points, const AzimuthSweep& sweep) {
  const float turns_per_radian = (sweep.clockwise ? -0.5f : 0.5f) / pi;
  const float start = static_cast<float>(sweep.start / 180.0) * pi * turns_per_radian;
  std::vector<float> fractions(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Two turns more make it positive, where truncation is floor and needs no call.
    const float turns = fastAtan2(points[i].y(), points[i].x()) * turns_per_radian - start + 2.f;
    fractions[i] = turns - static_cast<float>(static_cast<int>(turns));
  }
  return fractions;
}

}  // namespace revisit_slam
