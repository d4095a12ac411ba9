// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "revisit_slam/loops/acceptance/loop_closer.h"
#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/session/session_crossing.h"
#include "revisit_slam/session/session_summary.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// Many sessions in one graph, reduced to the keyposes of their submaps. Each keeps its odometry
/// and its own loops. Sessions are joined by loops that agree with each other (SessionJoining), two
/// groups of sessions at a time, and the graph is optimised; this goes on until no group can be
/// joined to another. Then all other loops between sessions in one map are taken that are where
/// the graph expects them, within what the odometry drifts. The same bits for any order of the
/// crossings.
class JointGraph {
 public:
  /// Does it all. Sessions are known by their names; crossings of other sessions are left out.
  /// @throws std::runtime_error where two sessions have one name, or a crossing is of other
  /// submaps.
  JointGraph(const SlamConfig& config, std::vector<SessionSummary> sessions,
             const std::vector<SessionCrossing>& crossings);

  const std::vector<SessionSummary>& sessions() const { return sessions_; }
  /// T_map_submap of a session, by the number of its submaps, in the map of its group.
  std::vector<Pose> keyposes(std::size_t session) const;
  /// The first session of the group that a session is in: its place in the list.
  std::size_t groupOf(std::size_t session) const;
  /// Loops between sessions that the graph was given. `from` and `to` number submaps, as `target`
  /// and `source` do, and sessions are numbered by their place in the list.
  std::vector<LoopEdge> loopsBetweenSessions() const;
  /// How far a loop is from where the graph has its keyposes: T_to_expected, of `to`.
  Pose residual(const LoopEdge& edge) const;
  /// Loops that nothing spoke for: their sessions are not joined, or the graph expects them
  /// elsewhere.
  std::size_t leftOut() const { return held_.size(); }
  /// Optimisations until the last sessions were joined.
  int rounds() const { return rounds_; }

 private:
  void addSessions();
  void hold(const std::vector<SessionCrossing>& crossings);
  void join();
  void takeExpected();
  std::vector<LoopConstraint> takeHeld(const std::vector<std::size_t>& which);
  std::vector<std::size_t> expected() const;

  const SlamConfig& config_;
  std::vector<SessionSummary> sessions_;
  SlamGraph graph_;
  SessionOffsets<ScanId> offsets_;  // of its nodes
  std::vector<LoopProposal> held_;  // not given to the graph
  int rounds_ = 0;
};

}  // namespace revisit_slam
