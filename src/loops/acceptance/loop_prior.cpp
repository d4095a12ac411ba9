// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/loop_prior.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace revisit_slam {
namespace {

constexpr double kDegrees = 180.0 / M_PI;

/// From the keypose of one submap to that of the next, m.
double driftBetween(const Submap& earlier, const Submap& later, const DriftConfig& config) {
  return config.rate * (later.travelled_begin - earlier.travelled_begin) +
         config.weak_rate * (later.unsure_begin.weak - earlier.unsure_begin.weak) +
         later.unsure_begin.doubt - earlier.unsure_begin.doubt;
}

}  // namespace

double LoopPrior::deviation(const Pose& T_target_source, const DriftConfig& config) const {
  if (std::isinf(drift)) return 0.0;
  const Pose error = this->T_target_source.inverse() * T_target_source;
  const Eigen::Vector3d moved = T_target_source.translation - this->T_target_source.translation;
  const double plane = moved.head<2>().norm() / drift;
  const double height = moved.z() / std::max(config.base, config.vertical_share * drift);
  const double turn = error.angle() * kDegrees / (config.rotation * drift);
  return std::sqrt(plane * plane + height * height + turn * turn);
}

GraphDrift::GraphDrift(std::vector<SubmapPtr> submaps, const std::vector<LoopEdge>& loops,
                       const DriftConfig& config)
    : base_(config.base), steps_(submaps.size()) {
  const auto connect = [&](std::size_t a, std::size_t b, double drift) {
    steps_[a].push_back({b, drift});
    steps_[b].push_back({a, drift});
  };
  for (const SubmapPtr& submap : submaps) submaps_.append(submap->id);
  for (std::size_t i = 1; i < submaps.size(); ++i)
    if (submaps[i]->id.session == submaps[i - 1]->id.session)
      connect(i - 1, i, driftBetween(*submaps[i - 1], *submaps[i], config));
  for (const LoopEdge& edge : loops)
    if (edge.state == LoopState::active)
      connect(submaps_[edge.loop.target], submaps_[edge.loop.source], config.base);
}

std::vector<double> GraphDrift::from(SubmapId submap) const {
  return search(submaps_[submap], steps_.size());
}

double GraphDrift::between(SubmapId a, SubmapId b) const {
  return search(submaps_[a], submaps_[b])[submaps_[b]];
}

/// Dijkstra's algorithm; ends when it has come to `until`.
std::vector<double> GraphDrift::search(std::size_t begin, std::size_t until) const {
  using Entry = std::pair<double, std::size_t>;
  std::vector<double> drift(steps_.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  open.push({base_, begin});
  while (!open.empty()) {
    const auto [so_far, index] = open.top();
    open.pop();
    if (so_far >= drift[index]) continue;
    drift[index] = so_far;
    if (index == until) break;
    for (const Step& step : steps_[index]) open.push({so_far + step.drift, step.to});
  }
  return drift;
}

}  // namespace revisit_slam
