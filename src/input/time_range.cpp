// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_range.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam {
namespace {

/// Of so many times, evenly taken, the quantiles are computed.
constexpr std::size_t kSamples = 1000;
/// Fewer have no bulk.
constexpr std::size_t kFewest = 20;
/// The bulk is between the quantiles of kTail and 1 - kTail. Times that are evenly spread reach an
/// eighth of its width beyond; kMargin of its width leaves room for uneven ones.
constexpr double kTail = 0.1;
constexpr double kMargin = 0.25;

std::vector<double> sampleOf(const std::vector<double>& times) {
  std::vector<double> sample;
  const std::size_t step = std::max<std::size_t>(1, times.size() / kSamples) | 1;
  for (std::size_t i = 0; i < times.size(); i += step)
    if (std::isfinite(times[i])) sample.push_back(times[i]);
  return sample;
}

double quantileOf(std::vector<double>& sample, double part) {
  const auto place = static_cast<std::ptrdiff_t>(part * static_cast<double>(sample.size() - 1));
  std::nth_element(sample.begin(), sample.begin() + place, sample.end());
  return sample[static_cast<std::size_t>(place)];
}

}  // namespace

TimeRange TimeRange::of(const std::vector<double>& times) {
  TimeRange range;
  double first = range.first;  // in registers: through the struct the loop takes twice as long
  double last = range.last;
  for (const double time : times) {
    if (!std::isfinite(time)) continue;
    first = time < first ? time : first;
    last = time > last ? time : last;
    ++range.finite;
  }
  range.first = first;
  range.last = last;
  return range;
}

TimeRange TimeRange::ofBulk(const std::vector<double>& times) {
  std::vector<double> sample = sampleOf(times);
  if (sample.size() < kFewest) return of(times);
  const double low = quantileOf(sample, kTail), high = quantileOf(sample, 1.0 - kTail);
  const double margin = kMargin * (high - low);
  TimeRange range;
  for (const double time : times) {
    if (!(low - margin <= time && time <= high + margin)) continue;
    range.first = std::min(range.first, time);
    range.last = std::max(range.last, time);
    ++range.finite;
  }
  return range;
}

}  // namespace revisit_slam
