// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/loop_prior.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

namespace revisit_slam {
namespace {

constexpr double kDegrees = 180.0 / M_PI;

/// From the keypose of one submap to that of the next. Never negative, whatever a saved map says:
/// the search would not end.
Drift driftBetween(const Submap& earlier, const Submap& later, const DriftConfig& config) {
  const UnsureDistance &from = earlier.unsure_begin, &to = later.unsure_begin;
  const double everywhere =
      config.rate * (later.travelled_begin - earlier.travelled_begin) + to.doubt - from.doubt;
  const double plane = everywhere + config.weak_rate * (to.weak - from.weak);
  const double height =
      config.vertical_share * everywhere + config.weak_rate * (to.weak_height - from.weak_height);
  return {std::max(0.0, plane), std::max(0.0, height)};
}

}  // namespace

double LoopPrior::deviation(const Pose& T_target_source, const DriftConfig& config) const {
  if (std::isinf(drift.plane)) return 0.0;
  const Pose error = this->T_target_source.inverse() * T_target_source;
  const Eigen::Vector3d moved = T_target_source.translation - this->T_target_source.translation;
  const double plane = moved.head<2>().norm() / drift.plane;
  const double height = moved.z() / std::max(config.base, drift.height);
  const double turn = error.angle() * kDegrees / (config.rotation * drift.plane);
  return std::sqrt(plane * plane + height * height + turn * turn);
}

GraphDrift::GraphDrift(std::vector<SubmapPtr> submaps, const std::vector<LoopEdge>& loops,
                       const DriftConfig& config)
    : base_{config.base, config.vertical_share * config.base}, steps_(submaps.size()) {
  const auto connect = [&](std::size_t a, std::size_t b, const Drift& drift) {
    steps_[a].push_back({b, drift});
    steps_[b].push_back({a, drift});
  };
  for (const SubmapPtr& submap : submaps) submaps_.append(submap->id);
  for (std::size_t i = 1; i < submaps.size(); ++i)
    if (submaps[i]->id.session == submaps[i - 1]->id.session)
      connect(i - 1, i, driftBetween(*submaps[i - 1], *submaps[i], config));
  for (const LoopEdge& edge : loops)
    if (edge.state == LoopState::active)
      connect(submaps_[edge.loop.target], submaps_[edge.loop.source], base_);
}

std::vector<Drift> GraphDrift::from(SubmapId submap) const {
  return search(submaps_[submap], steps_.size());
}

Drift GraphDrift::between(SubmapId a, SubmapId b) const {
  return search(submaps_[a], submaps_[b])[submaps_[b]];
}

/// Dijkstra's algorithm; ends when it has come to `until`.
std::vector<Drift> GraphDrift::search(std::size_t begin, std::size_t until) const {
  using Entry = std::tuple<double, double, std::size_t>;  // drift in the plane, in height, submap
  std::vector<Drift> drift(steps_.size());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  open.push({base_.plane, base_.height, begin});
  while (!open.empty()) {
    const auto [plane, height, index] = open.top();
    open.pop();
    if (!(plane < drift[index].plane)) continue;
    drift[index] = {plane, height};
    if (index == until) break;
    for (const Step& step : steps_[index])
      open.push({plane + step.drift.plane, height + step.drift.height, step.to});
  }
  return drift;
}

}  // namespace revisit_slam
