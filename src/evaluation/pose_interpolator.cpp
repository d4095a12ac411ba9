// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/pose_interpolator.h"

#include <algorithm>
#include <utility>

namespace revisit_slam {
namespace {

bool isEarlier(const StampedPose& a, const StampedPose& b) {
  return a.stamp < b.stamp;
}

Pose between(const Pose& a, const Pose& b, double fraction) {
  return {a.rotation.slerp(fraction, b.rotation).normalized(),
          a.translation + fraction * (b.translation - a.translation)};
}

}  // namespace

PoseInterpolator::PoseInterpolator(Trajectory trajectory, double longest_gap)
    : poses_(std::move(trajectory)), longest_gap_(longest_gap) {
  std::stable_sort(poses_.begin(), poses_.end(), isEarlier);
  const auto same = [](const auto& a, const auto& b) { return a.stamp == b.stamp; };
  poses_.erase(std::unique(poses_.begin(), poses_.end(), same), poses_.end());
}

PoseAnswer PoseInterpolator::at(Stamp stamp) const {
  using Kind = PoseAnswer::Kind;
  const auto later =
      std::lower_bound(poses_.begin(), poses_.end(), StampedPose{stamp, {}}, isEarlier);
  if (later != poses_.end() && later->stamp == stamp) return {Kind::found, later->T_world_base};
  if (later == poses_.begin() || later == poses_.end()) {
    if (poses_.empty()) return {Kind::outside, {}};
    const StampedPose& end = later == poses_.end() ? poses_.back() : poses_.front();
    const bool near = std::abs(secondsBetween(end.stamp, stamp)) <= kBeyond;
    return {near ? Kind::found : Kind::outside, end.T_world_base};
  }
  const StampedPose &a = *(later - 1), &b = *later;
  const double gap = secondsBetween(a.stamp, b.stamp);
  if (gap > longest_gap_) return {Kind::in_gap, {}};
  return {Kind::found,
          between(a.T_world_base, b.T_world_base, secondsBetween(a.stamp, stamp) / gap)};
}

}  // namespace revisit_slam
