// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/association/hausdorff.h"

#include <algorithm>
#include <utility>

namespace revisit_slam {
namespace {

/// Travelled distances are sums that round; leaps are shorter by this, metres.
constexpr double kRounding = 1e-6;

/// max over a of min over b, at least `largest`.
double directedDistance(const Path& a, const Path& b, double largest, double limit) {
  for (std::size_t i = 0; i < a.size();) {
    const double distance = b.distanceTo(a[i], largest);
    largest = std::max(largest, distance);
    if (largest > limit) return kAnyDistance;
    i = a.leap(i, largest - distance);
  }
  return largest;
}

}  // namespace

Path::Path(std::vector<Eigen::Vector3d> positions) : positions_(std::move(positions)) {
  travelled_.resize(positions_.size(), 0.0);
  for (std::size_t i = 1; i < positions_.size(); ++i)
    travelled_[i] = travelled_[i - 1] + (positions_[i] - positions_[i - 1]).norm();
}

std::size_t Path::leap(std::size_t index, double distance) const {
  const auto next = travelled_.begin() + static_cast<std::ptrdiff_t>(index) + 1;
  if (distance <= kRounding) return index + 1;
  return static_cast<std::size_t>(
      std::upper_bound(next, travelled_.end(), travelled_[index] + distance - kRounding) -
      travelled_.begin());
}

double Path::distanceTo(const Eigen::Vector3d& p, double enough) const {
  double nearest = kAnyDistance;
  for (std::size_t i = 0; i < positions_.size() && nearest > enough;) {
    const double distance = (positions_[i] - p).norm();
    nearest = std::min(nearest, distance);
    i = leap(i, distance - nearest);
  }
  return nearest;
}

double hausdorffDistance(const Path& a, const Path& b, double limit) {
  if (a.size() == 0 || b.size() == 0) return kAnyDistance;
  const double from_a = directedDistance(a, b, 0.0, limit);
  return from_a > limit ? kAnyDistance : directedDistance(b, a, from_a, limit);
}

bool comeWithin(const Path& a, const Path& b, double distance) {
  for (std::size_t i = 0; i < a.size();) {
    const double nearest = b.distanceTo(a[i], distance);
    if (nearest <= distance) return true;
    i = a.leap(i, nearest - distance);
  }
  return false;
}

}  // namespace revisit_slam
