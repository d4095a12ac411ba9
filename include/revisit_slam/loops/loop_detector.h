// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "revisit_slam/loops/acceptance/loop_closer.h"
#include "revisit_slam/loops/acceptance/session_joining.h"
#include "revisit_slam/loops/recognition/place_recognition.h"
#include "revisit_slam/loops/search/loop_search_result.h"
#include "revisit_slam/loops/search/loops_config.h"
#include "revisit_slam/loops/search/retroactive_search.h"
#include "revisit_slam/loops/search/tried_pairs.h"
#include "revisit_slam/mapping/submap_library.h"
#include "revisit_slam/types/map_correction.h"
#include "revisit_slam/types/scan_poses.h"
#include "revisit_slam/types/session_groups.h"
#include "revisit_slam/types/session_offsets.h"

namespace revisit_slam {

/// Finds the loops of a session, or of several (paper Sec. III-C and III-E): by appearance for each
/// local map, and retroactively among the maps that the graph has brought together. Loops between
/// sessions that nothing ties yet wait until enough of them agree (SessionJoining). What it finds
/// depends on the order of calls alone. All its work runs in the current TBB arena.
class LoopDetector {
 public:
  /// `library`: where the points of its submaps are; null: they stay with the local maps.
  LoopDetector(const LoopsConfig& loops, const RetroactiveConfig& retroactive,
               const InformationConfig& information, std::shared_ptr<SubmapLibrary> library = {});

  /// Takes effect with the next search. What accepts a loop may change while a drive goes on,
  /// pictures and registration may not.
  void reconfigure(const LoopsConfig& loops, const RetroactiveConfig& retroactive);

  /// A local map of a session that was searched for loops before, as place recognition has seen it;
  /// all of its session before any of another. Where it lies the next correction says.
  void addSearched(const LocalMapPtr& map, const PlaceView& view);

  /// The next local map of the session: recognises the place that it shows among all earlier ones,
  /// and registers the submaps of both.
  LoopSearchResult searchByAppearance(const LocalMapPtr& map);

  /// One of the maps that were searched before, among those of the sessions before `first`.
  LoopSearchResult searchAcrossSessions(LocalMapId map, SessionId first);

  /// After the graph has taken loops: pairs of maps since the last such search that it has brought
  /// together, up to map n, or the newest. These maps count as searched afterwards.
  LoopSearchResult searchRetroactively(std::optional<LocalMapId> n = {});

  /// Pairs of maps since the last search by searchRetroactively(), without counting them as
  /// searched: a closure that comes later searches them with better poses. Each call takes the next
  /// pairs that were not `tried`, `batches` times as many as another search may, until there are
  /// none. First come loops that join sessions.
  LoopSearchResult searchUnspent(TriedPairs& tried, std::size_t batches = 1);
  /// Pairs that were tried, and of which the graph says something else by now.
  void forgetChanged(TriedPairs& tried) const;

  /// Where appearance closed no loop: the newest map and those so little of the way back that the
  /// odometry alone places them.
  LoopSearchResult searchLowDriftWindow();

  /// Where the graph has the scans, and which loops it has taken.
  void correct(const MapCorrectionPtr& correction);

  bool hasClosedLoops() const { return !closed_.empty(); }
  /// Whether the graph has taken a loop of the newest map.
  bool newestIsClosed() const;
  /// Without the points that are in the library.
  const std::vector<LocalMapPtr>& maps() const { return maps_; }

 private:
  void add(const LocalMapPtr& map);
  LocalMapPtr withoutPoints(const LocalMapPtr& map) const;
  LocalMapPtr mapOf(LocalMapId id) const;
  ScanPoses placeScans() const;
  PairGuess guessOf(const LocalMapPair& maps, const ScanPoses& T_map_scan,
                    const GraphDrift& drift) const;
  using Partners = std::map<LocalMapId, std::set<LocalMapId>>;

  bool areWellTied(const LocalMapPair& maps, const Partners& partners) const;
  GraphDrift graphDrift() const;
  PriorOf priorsOf(const ScanPoses& T_map_scan) const;
  void closeMatches(const LocalMap& source, LoopSearchResult& result);
  void believe(LoopSearchResult& result);
  void searchAgainWhatWasJoined(const SessionGroups& groups);
  std::vector<LoopProposal> closeByAppearance(const LocalMap& source,
                                              const PlaceMatch& match) const;
  LoopSearchResult newSearch(LoopOrigin origin) const;
  bool searchWindow(LocalMapId n, std::size_t most, TriedPairs& tried,
                    LoopSearchResult& result) const;
  std::vector<LocalMapPair> close(const std::vector<RetroactiveCandidate>& candidates,
                                  std::size_t most, const ScanPoses& T_map_scan,
                                  LoopSearchResult& result) const;

  bool enabled_;
  DriftConfig drift_;
  std::size_t max_pairs_, max_partners_;
  bool search_at_end_;
  PlaceRecognition recognition_;
  LoopCloser appearance_closer_, retroactive_closer_;
  RetroactiveSearch retroactive_;
  SessionJoining joining_;

  std::shared_ptr<SubmapLibrary> library_;
  std::vector<LocalMapPtr> maps_;          // of each session by number, session after session
  SessionOffsets<LocalMapId> order_;       // of maps_
  SessionOffsets<ScanId> scans_;           // of maps_
  std::map<LocalMapId, PlaceView> views_;  // of those that were searched before
  SessionGroups groups_;                   // as the graph ties the sessions
  MapCorrectionPtr correction_;            // the newest; null: none yet
  std::set<LocalMapPair> closed_;          // by the graph
  Partners partners_;                      // in closed_, other maps than itself
  TriedPairs tried_;                       // after the window was last searched to its end
  std::optional<LocalMapId> searched_;     // p: up to it all maps were searched retroactively
};

}  // namespace revisit_slam
