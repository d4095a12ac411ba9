// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "revisit_slam/loops/loop_detector.h"
#include "revisit_slam/session/known_map.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/types/loop_closures.h"
#include "revisit_slam/types/maps_closed.h"

namespace revisit_slam {

/// The feedback between loops and graph (paper Sec. III-E), for one session or for several: local
/// map n is searched by appearance, the graph takes what was found and answers with a correction,
/// the corrected maps are searched retroactively, the graph takes that too, and only then comes
/// local map n + 1. So what is found depends on the order of scans, and not on that of threads.
class LoopClosing {
 public:
  /// What it hands on, in the thread that called.
  struct Outputs {
    std::function<void(const LoopSearchResult&)> search;
    std::function<void(const LoopClosures&)> closures;
    std::function<void(const MapsClosed&)> closed;
    std::function<void(const std::string&)> problem;  ///< a search that threw; the next one follows
  };

  /// `library`: LoopDetector.
  LoopClosing(const SlamConfig& config, Outputs outputs,
              const std::shared_ptr<SubmapLibrary>& library = {});

  void reconfigure(const LoopsConfig& loops, const RetroactiveConfig& retroactive);

  /// Sessions that were mapped before, with their loops. Before anything else.
  void goOnFrom(const std::vector<const KnownMap*>& maps);

  void add(const LocalMapPtr& map);
  /// One that was searched before, among those of the sessions before `first`.
  void searchAcrossSessions(LocalMapId map, SessionId first);
  /// Searches to the end of what is left when all maps so far are searched, and then passes
  /// `closed` on.
  void finish(const MapsClosed& closed);
  /// The graph's answer, or another correction.
  void correct(const MapCorrectionPtr& correction);
  /// There is no graph that could answer.
  void giveUpWaiting();

  /// Local maps that have not been searched wholly.
  std::size_t waiting() const;
  /// Nothing waits, neither for its turn nor for the graph.
  bool isIdle() const { return work_.empty() && !awaited_; }

 private:
  struct Across {
    LocalMapId map;
    SessionId first;
  };
  using Work = std::variant<LocalMapPtr, Across, MapsClosed>;
  struct Awaited {
    std::uint32_t request;
    std::function<void()> then;
  };

  void advance();
  void goOn();
  void guarded(const std::function<void()>& work) const;
  void begin(const LocalMapPtr& map);
  void begin(const Across& across);
  void begin(const MapsClosed& closed);
  void searchAfterAnswer();
  void searchToTheEnd(const MapsClosed& closed, std::size_t batches);
  bool hand(const LoopSearchResult& result, std::function<void()> then);

  bool with_measurements_;  // of GNSS or gravity: the graph may change without loops, and answers
  LoopDetector detector_;
  const Outputs outputs_;
  std::deque<Work> work_;  // not begun
  std::uint32_t requests_ = 0;
  std::optional<Awaited> awaited_;  // the graph's answer; meanwhile nothing is begun
  TriedPairs tried_at_the_end_;
};

}  // namespace revisit_slam
