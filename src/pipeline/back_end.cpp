// SPDX-License-Identifier: MIT
#include "revisit_slam/pipeline/back_end.h"

#include <chrono>
#include <stdexcept>
#include <utility>

namespace revisit_slam {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

BackEnd::BackEnd(const SlamConfig& config, OnCorrection on_correction, OnProposals on_proposals)
    : graph_(config.backend),
      closer_(config.loops.closer, config.information),
      retroactive_(config.retroactive),
      max_pairs_(config.retroactive.max_pairs),
      on_correction_(std::move(on_correction)),
      on_proposals_(std::move(on_proposals)) {}

void BackEnd::add(const LocalMapPtr& map, const std::vector<LoopConstraint>& loops) {
  if (map->submaps.back()->lastScan().value >= graph_.size())
    throw std::invalid_argument("a local map came before its scans");
  maps_.push_back(map);
  if (loops.empty()) return;
  for (const LoopConstraint& loop : loops) closed_.insert({loop.source_map, loop.target_map});
  optimise(loops);
  searchRetroactively();
}

void BackEnd::finish() {
  if (!maps_.empty() && !closed_.empty()) searchRetroactively();
}

void BackEnd::optimise(const std::vector<LoopConstraint>& new_loops) {
  const bool taken = graph_.optimise(lastScanOfMaps(), new_loops);
  ++count_.optimisations;
  count_.optimisation_seconds += graph_.lastSolution().seconds;
  if (!taken) ++count_.rejected_optimisations;
  MapCorrection correction;
  correction.version = ++version_;
  for (std::uint32_t i = 0; i <= lastScanOfMaps().value; ++i)
    correction.T_map_scan.push_back(graph_.pose(ScanId{i}));
  correction.T_map_odom = graph_.T_map_odom();
  correction.loops = graph_.loops();
  correction.moved_end = taken ? graph_.movedEnd() : 0.0;
  correction.seconds = graph_.lastSolution().seconds;
  on_correction_(std::make_shared<const MapCorrection>(std::move(correction)));
}

void BackEnd::searchRetroactively() {
  const Clock::time_point start = Clock::now();
  const LocalMapId newest = maps_.back()->id;
  const std::vector<Pose> T_map_scan = graph_.poses();
  std::vector<LoopConstraint> loops;
  int pairs = 0;
  bool all = true;
  for (const RetroactiveCandidate& candidate :
       retroactive_.search(maps_, T_map_scan, searched_, newest, closed_)) {
    if (tried_.count(candidate.maps) > 0) continue;
    all = pairs < max_pairs_;
    if (!all) break;
    const std::vector<LoopProposal> proposals = closeRetroactively(candidate.maps, T_map_scan);
    pairs += static_cast<int>(proposals.size());
    const std::vector<LoopConstraint> accepted = acceptedOf(proposals);
    loops.insert(loops.end(), accepted.begin(), accepted.end());
  }
  if (all) searched_ = newest;
  count_.retroactive_pairs += pairs;
  count_.retroactive_seconds += secondsSince(start);
  if (!loops.empty()) optimise(loops);
}

std::vector<LoopProposal> BackEnd::closeRetroactively(const LocalMapPair& maps,
                                                      const std::vector<Pose>& T_map_scan) {
  tried_.insert(maps);
  const auto placed = [&](LocalMapId id) { return placeByGraph(*maps_[id.value], T_map_scan); };
  const std::vector<LoopProposal> proposals =
      closer_.close(placed(maps.first), placed(maps.second), LoopOrigin::retroactive);
  if (on_proposals_) on_proposals_(proposals);
  if (!acceptedOf(proposals).empty()) closed_.insert(maps);
  return proposals;
}

bool BackEnd::takeBack(LoopId id) {
  if (!graph_.takeBack(id)) return false;
  optimise({});
  return true;
}

Trajectory BackEnd::trajectory() const {
  Trajectory trajectory;
  trajectory.reserve(graph_.size());
  for (const GraphNode& node : graph_.nodes())
    trajectory.push_back({node.stamp, graph_.pose(node.id)});
  return trajectory;
}

}  // namespace revisit_slam
