// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/loop_closing.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

#include "revisit_slam/slam/map_correction.h"

namespace revisit_slam {

LoopClosing::LoopClosing(const SlamConfig& config, Outputs outputs,
                         const std::shared_ptr<SubmapLibrary>& library)
    : with_measurements_(config.gnss.isConnected() ||
                         (config.gravity.enabled && !config.priors.imu_topic.empty())),
      detector_(config.loops, config.retroactive, config.information, library),
      outputs_(std::move(outputs)) {}

void LoopClosing::reconfigure(const LoopsConfig& loops, const RetroactiveConfig& retroactive) {
  detector_.reconfigure(loops, retroactive);
  tried_at_the_end_.clear();
}

void LoopClosing::goOnFrom(const std::vector<const KnownMap*>& maps) {
  for (const KnownMap* map : maps) {
    for (std::size_t i = 0; i < map->maps.size(); ++i)
      detector_.addSearched(map->maps[i], map->places[i]);
    with_measurements_ |=
        std::any_of(map->nodes.begin(), map->nodes.end(),
                    [](const GraphNode& node) { return node.gravity || !node.fixes.empty(); });
  }
  detector_.correct(std::make_shared<const MapCorrection>(correctionOf(maps)));
}

void LoopClosing::searchAcrossSessions(LocalMapId map, SessionId first) {
  work_.emplace_back(Across{map, first});
  advance();
}

void LoopClosing::add(const LocalMapPtr& map) {
  work_.push_back(map);
  advance();
}

void LoopClosing::finish(const MapsClosed& closed) {
  work_.push_back(closed);
  advance();
}

void LoopClosing::correct(const MapCorrectionPtr& correction) {
  if (correction->version > 0) detector_.correct(correction);
  if (awaited_ && correction->request == awaited_->request) goOn();
}

void LoopClosing::giveUpWaiting() {
  if (awaited_) goOn();
}

void LoopClosing::goOn() {
  const Awaited answered = std::move(*awaited_);
  awaited_.reset();
  guarded(answered.then);
  advance();
}

std::size_t LoopClosing::waiting() const {
  const auto is_map = [](const Work& work) { return !std::holds_alternative<MapsClosed>(work); };
  return static_cast<std::size_t>(std::count_if(work_.begin(), work_.end(), is_map)) +
         (awaited_ ? 1 : 0);
}

void LoopClosing::advance() {
  while (!awaited_ && !work_.empty()) {
    const Work next = std::move(work_.front());
    work_.pop_front();
    guarded([&] { std::visit([this](const auto& work) { begin(work); }, next); });
  }
}

/// What one search throws is reported; the next one follows.
void LoopClosing::guarded(const std::function<void()>& work) const {
  try {
    work();
  } catch (const std::exception& error) {
    outputs_.problem(error.what());
  }
}

void LoopClosing::begin(const LocalMapPtr& map) {
  LoopSearchResult result;
  result.map = map;  // which is passed on whatever happens: others keep it until then
  guarded([&] { result = detector_.searchByAppearance(map); });
  const bool is_waiting = hand(result, [this] { searchAfterAnswer(); });
  if (!is_waiting) hand(detector_.searchLowDriftWindow(), [] {});
}

void LoopClosing::begin(const Across& across) {
  const LoopSearchResult result = detector_.searchAcrossSessions(across.map, across.first);
  const bool has_loops = !result.accepted().empty();
  hand(result, [this, across, has_loops] {
    if (has_loops) hand(detector_.searchRetroactively(across.map), [] {});
  });
}

/// What the graph has rejected is no closure.
void LoopClosing::searchAfterAnswer() {
  hand(detector_.newestIsClosed() ? detector_.searchRetroactively()
                                  : detector_.searchLowDriftWindow(),
       [] {});
}

void LoopClosing::begin(const MapsClosed& closed) {
  guarded([this] { detector_.forgetChanged(tried_at_the_end_); });
  searchToTheEnd(closed, 1);
}

/// As long as there are pairs that have not been tried. The graph moves between, less each time, so
/// each time twice as many are tried. Whatever happens, `closed` is passed on: others wait for it.
void LoopClosing::searchToTheEnd(const MapsClosed& closed, std::size_t batches) {
  bool is_waiting = false;
  guarded([&] {
    while (detector_.hasClosedLoops() && !is_waiting) {
      const LoopSearchResult result = detector_.searchUnspent(tried_at_the_end_, batches);
      if (result.proposals.empty()) return;
      is_waiting = hand(result, [this, closed, batches] { searchToTheEnd(closed, 2 * batches); });
    }
  });
  if (!is_waiting) outputs_.closed(closed);
}

/// `then` follows when the graph has taken the loops, if there are any, or positions of GNSS
/// or directions of gravity.
/// @return whether it does.
bool LoopClosing::hand(const LoopSearchResult& result, std::function<void()> then) {
  LoopClosures closures;
  closures.map = result.map->id;
  closures.last_scan = result.map->submaps.back()->lastScan();
  closures.origin = result.origin;
  closures.constraints = result.accepted();
  closures.view = result.view;
  for (const LoopProposal& proposal : result.proposals)
    closures.candidates.push_back(candidateOf(proposal));
  const bool has_answer = !closures.constraints.empty() || with_measurements_;
  if (has_answer) {
    closures.request = ++requests_;
    awaited_ = {closures.request, std::move(then)};
  }
  outputs_.closures(closures);
  guarded([&] { outputs_.search(result); });
  return has_answer;
}

}  // namespace revisit_slam
