// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/loop_closing.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace revisit_slam {

LoopClosing::LoopClosing(const SlamConfig& config, Outputs outputs)
    : detector_(config.loops, config.retroactive, config.information),
      outputs_(std::move(outputs)) {}

void LoopClosing::reconfigure(const LoopsConfig& loops, const RetroactiveConfig& retroactive) {
  detector_.reconfigure(loops, retroactive);
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
  detector_.correct(correction);
  if (!awaited_ || correction->request != awaited_->request) return;
  const Awaited answered = std::move(*awaited_);
  awaited_.reset();
  answered.then();
  advance();
}

std::size_t LoopClosing::waiting() const {
  const auto is_map = [](const Work& work) { return std::holds_alternative<LocalMapPtr>(work); };
  return static_cast<std::size_t>(std::count_if(work_.begin(), work_.end(), is_map)) +
         (awaited_ ? 1 : 0);
}

void LoopClosing::advance() {
  while (!awaited_ && !work_.empty()) {
    const Work next = std::move(work_.front());
    work_.pop_front();
    try {
      std::visit([this](const auto& work) { begin(work); }, next);
    } catch (const std::exception& error) {
      outputs_.problem(error.what());
    }
  }
}

void LoopClosing::begin(const LocalMapPtr& map) {
  const LoopSearchResult result = detector_.searchByAppearance(map);
  const bool is_closed = !result.accepted().empty();
  hand(result, [this] { searchAfterAnswer(); });
  if (!is_closed) hand(detector_.searchLowDriftWindow(), [] {});
}

/// What the graph has rejected is no closure.
void LoopClosing::searchAfterAnswer() {
  hand(detector_.newestIsClosed() ? detector_.searchRetroactively()
                                  : detector_.searchLowDriftWindow(),
       [] {});
}

void LoopClosing::begin(const MapsClosed& closed) {
  tried_at_the_end_.clear();
  searchToTheEnd(closed);
}

/// As long as there are pairs that have not been tried; the graph moves between.
void LoopClosing::searchToTheEnd(const MapsClosed& closed) {
  while (detector_.hasClosedLoops()) {
    const LoopSearchResult result = detector_.searchUnspent(tried_at_the_end_);
    if (result.proposals.empty()) break;
    const bool is_closed = !result.accepted().empty();
    hand(result, [this, closed] { searchToTheEnd(closed); });
    if (is_closed) return;
  }
  outputs_.closed(closed);
}

/// `then` follows when the graph has taken the loops, if there are any.
void LoopClosing::hand(const LoopSearchResult& result, std::function<void()> then) {
  LoopClosures closures;
  closures.map = result.map->id;
  closures.last_scan = result.map->submaps.back()->lastScan();
  closures.origin = result.origin;
  closures.constraints = result.accepted();
  if (!closures.constraints.empty()) {
    closures.request = ++requests_;
    awaited_ = {closures.request, std::move(then)};
  }
  outputs_.search(result);
  outputs_.closures(closures);
}

}  // namespace revisit_slam
