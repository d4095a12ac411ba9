// SPDX-License-Identifier: MIT
#include "revisit_slam/input/viewed_directions.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/input/azimuth_times.h"

namespace revisit_slam {
namespace {

/// Of so many points, evenly taken, the directions are computed.
constexpr std::size_t kSamples = 4000;

/// The step is odd: with an even one, rows of 16, 32 or 64 beams would give the same beams again.
Points sampleOf(const Points& points) {
  Points sample;
  const std::size_t step = std::max<std::size_t>(1, points.size() / kSamples) | 1;
  sample.reserve(points.size() / step + 1);
  for (std::size_t i = 0; i < points.size(); i += step) sample.push_back(points[i]);
  return sample;
}

}  // namespace

double turnBetween(double from, double to) {
  const double turn = std::fmod(to - from + 180.0, 360.0);
  return turn < 0.0 ? turn + 180.0 : turn - 180.0;
}

void ViewedDirections::add(const Points& points) {
  const AzimuthSweep from_x{false, 0.0};
  for (const float turns : sweepFractions(sampleOf(points), from_x))
    degrees_.set(std::min<std::size_t>(359, static_cast<std::size_t>(360.f * turns)));
}

ViewSector ViewedDirections::sector() const {
  if (degrees_.none()) return {};
  int widest_gap = 0, end_of_gap = 0, gap = 0;
  for (int i = 0; i < 2 * 360; ++i) {  // the gap may be across 0
    if (!degrees_.test(static_cast<std::size_t>(i % 360))) {
      ++gap;
      continue;
    }
    if (gap > widest_gap && gap < 360) {
      widest_gap = gap;
      end_of_gap = i;
    }
    gap = 0;
  }
  const double width = 360.0 - widest_gap;
  return {std::fmod(end_of_gap + 0.5 * width, 360.0), width};
}

}  // namespace revisit_slam
