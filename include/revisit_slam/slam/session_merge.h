// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/session/known_map.h"
#include "revisit_slam/slam/loop_closing.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/util/lane.h"

namespace revisit_slam {

/// Brings several sessions into one map. Each keeps its odometry and the loops that its drive has
/// found. Local map after local map of the second session, of the third, and so on is searched by
/// appearance among the sessions before; loops that agree join two sessions (SessionJoining), the
/// graph answers, what it has brought together is searched retroactively, and only then follows the
/// next local map (paper Sec. III-C to III-E). The same bits for any number of threads.
class SessionMerge {
 public:
  using OnSearch = std::function<void(const LoopSearchResult&)>;

  /// Does it all. The maps must outlive this. @throws std::runtime_error
  SessionMerge(const SlamConfig& config, const std::vector<KnownMap>& maps, OnSearch on_search);

  /// Of the maps those that are in one map, as most as there are: their places in the list.
  std::vector<std::size_t> joined() const;
  /// Of a map, whether it is one of these.
  bool isJoined(std::size_t map) const;

  const SlamGraph& graph() const { return graph_; }

  /// Writes the maps that are joined as one session into an unused folder.
  /// @throws std::runtime_error naming what cannot be read or written.
  void write(const std::string& folder) const;

 private:
  LoopClosing::Outputs outputs(OnSearch on_search);
  void addMaps();
  void answer(const LoopClosures& closures);
  std::optional<Georeference> georeference() const;
  SessionId sessionOf(std::size_t map) const;

  const SlamConfig config_;
  const std::vector<KnownMap>& maps_;
  SlamGraph graph_;
  InlineLane lane_;
  LoopClosing closing_;
};

}  // namespace revisit_slam
