// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/ring_spacing.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/geometry/spread_order.h"

namespace revisit_slam {
namespace {

/// Of the sine of the elevation, from -1 to 1: 0.1 degrees at the horizon.
constexpr int kBins = 1144;
constexpr float kBinWidth = 2.0f / (kBins - 1);
/// As many are looked at; they show each of 128 rings a hundred times.
constexpr std::size_t kMostPoints = 16384;
/// Bins with fewer points than this share of the mean of those that have any are between rings.
constexpr double kFewestShare = 0.05;
/// Bins that a ring has at most: it may lie across the border of two.
constexpr int kWidestRing = 2;

/// On the axis of the sensor no direction is across the rings, and sines round to more than 1.
constexpr double kSmallestCosine = 0.01;

/// Neighbouring bins with points: a ring, or rings that cannot be told apart.
struct Band {
  int first, last;
  int points;

  bool isRing() const { return last - first < kWidestRing; }
  float middle() const { return 0.5f * static_cast<float>(first + last); }
};

std::vector<Band> bandsOf(const std::vector<int>& counts) {
  int points = 0, used = 0;
  for (const int count : counts) {
    points += count;
    used += count > 0;
  }
  const double fewest = kFewestShare * points / std::max(used, 1);
  std::vector<Band> bands;
  for (int i = 0; i < kBins; ++i) {
    if (counts[i] <= fewest) continue;
    if (bands.empty() || bands.back().last < i - 1) bands.push_back({i, i, 0});
    bands.back().last = i;
    bands.back().points += counts[i];
  }
  return bands;
}

/// Whether most points lie on rings.
bool hasRings(const std::vector<Band>& bands) {
  int on_rings = 0, points = 0;
  for (const Band& band : bands) {
    points += band.points;
    if (band.isRing()) on_rings += band.points;
  }
  return bands.size() > 1 && 2 * on_rings > points;
}

}  // namespace

std::size_t RingSpacing::bin(double sine) {
  return static_cast<std::size_t>(std::clamp(0.5 * (sine + 1.0), 0.0, 1.0) * (kBins - 1) + 0.5);
}

RingSpacing::RingSpacing(const Points& points_sensor, const Pose& T_base_sensor)
    : sensor_base_(T_base_sensor.translation), axis_base_(T_base_sensor.rotationMatrix().col(2)) {
  std::vector<int> counts(kBins, 0);
  SpreadOrder order(points_sensor.size());
  for (std::size_t i = 0; i < std::min(points_sensor.size(), kMostPoints); ++i) {
    const Eigen::Vector3f& point = points_sensor[order.next()];
    const float range = point.norm();
    if (range > 0.0f) ++counts[bin(point.z() / range)];
  }
  const std::vector<Band> bands = bandsOf(counts);
  if (!hasRings(bands)) return;
  gaps_.assign(kBins, 0.0f);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const Band& band = bands[i];
    if (!band.isRing()) continue;
    float nearest = kBins;
    if (i > 0) nearest = band.middle() - bands[i - 1].middle();
    if (i + 1 < bands.size()) nearest = std::min(nearest, bands[i + 1].middle() - band.middle());
    // Deskewing and noise may carry a point over the border of its bin.
    for (int b = std::max(0, band.first - 1); b <= std::min(kBins - 1, band.last + 1); ++b)
      gaps_[b] = nearest * kBinWidth;
  }
}

AcrossRings RingSpacing::at(const Eigen::Vector3d& p_base, double resolution) const {
  if (gaps_.empty()) return {};
  const Eigen::Vector3d ray = p_base - sensor_base_;
  const double range = ray.norm();
  const double sine = range > 0.0 ? axis_base_.dot(ray) / range : 1.0;
  const double cosine = std::sqrt(std::max(kSmallestCosine * kSmallestCosine, 1.0 - sine * sine));
  const double spacing = range * gap(sine) / cosine;
  if (spacing <= resolution) return {};
  const double known = resolution / spacing;
  return {(axis_base_ - sine / range * ray) / cosine, 1.0 - known * known};
}

}  // namespace revisit_slam
