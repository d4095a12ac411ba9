// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/back_end.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace revisit_slam {
namespace {

RetroactiveConfig searchConfig(const SlamConfig& config) {
  RetroactiveConfig search = config.retroactive;
  search.enabled = search.enabled && config.loops.enabled;
  return search;
}

/// Associates submaps by the limits by which the search finds local maps.
LoopCloserConfig closerConfig(const SlamConfig& config) {
  LoopCloserConfig closer = config.loops.closer;
  closer.association = config.retroactive.association;
  return closer;
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

BackEnd::BackEnd(const SlamConfig& config, OnCorrection on_correction, OnProposals on_proposals)
    : graph_(config.backend),
      closer_(closerConfig(config), config.information),
      retroactive_(searchConfig(config)),
      max_pairs_(config.retroactive.max_pairs),
      on_correction_(std::move(on_correction)),
      on_proposals_(std::move(on_proposals)) {}

void BackEnd::reconfigure(const SlamConfig& config) {
  graph_.reconfigure(config.backend);
  closer_.reconfigure(closerConfig(config));
  retroactive_.reconfigure(searchConfig(config));
  max_pairs_ = config.retroactive.max_pairs;
}

void BackEnd::add(const LocalMapPtr& map, const std::vector<LoopConstraint>& loops) {
  if (map->submaps.back()->lastScan().value >= graph_.size())
    throw std::invalid_argument("a local map came before its scans");
  maps_.push_back(map);
  if (loops.empty()) return searchInReach();
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
  std::vector<RetroactiveCandidate> candidates =
      retroactive_.search(maps_, T_map_scan, searched_, newest, closed_);
  const auto was_tried = [&](const auto& candidate) { return tried_.count(candidate.maps) > 0; };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), was_tried),
                   candidates.end());
  const std::size_t done = close(candidates, T_map_scan, start);
  for (std::size_t i = 0; i < done; ++i) tried_.insert(candidates[i].maps);
  if (done == candidates.size()) searched_ = newest;
}

/// What is not closed now may be once the graph has moved it: it does not count as tried.
void BackEnd::searchInReach() {
  const Clock::time_point start = Clock::now();
  const std::vector<Pose> T_map_scan = graph_.poses();
  close(retroactive_.searchInReach(maps_, T_map_scan, maps_.back()->id, closed_), T_map_scan, start);
}

/// As many as may be at a time, and then optimises. @return how many were tried.
std::size_t BackEnd::close(const std::vector<RetroactiveCandidate>& candidates,
                           const std::vector<Pose>& T_map_scan, Clock::time_point start) {
  std::vector<LoopConstraint> loops;
  int pairs = 0;
  std::size_t done = 0;
  for (; done < candidates.size() && pairs < max_pairs_; ++done) {
    const std::vector<LoopProposal> proposals = close(candidates[done].maps, T_map_scan);
    pairs += static_cast<int>(proposals.size());
    const std::vector<LoopConstraint> accepted = acceptedOf(proposals);
    loops.insert(loops.end(), accepted.begin(), accepted.end());
  }
  count_.retroactive_pairs += pairs;
  count_.retroactive_seconds += secondsSince(start);
  if (!loops.empty()) optimise(loops);
  return done;
}

std::vector<LoopProposal> BackEnd::close(const LocalMapPair& maps,
                                         const std::vector<Pose>& T_map_scan) {
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
