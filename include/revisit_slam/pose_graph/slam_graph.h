// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "revisit_slam/pose_graph/back_end_config.h"
#include "revisit_slam/pose_graph/gnss_factors.h"
#include "revisit_slam/pose_graph/graph_node.h"
#include "revisit_slam/pose_graph/gravity_factors.h"
#include "revisit_slam/pose_graph/pose_graph.h"
#include "revisit_slam/pose_graph/pose_graph_solution.h"
#include "revisit_slam/types/map_correction.h"
#include "revisit_slam/types/session_groups.h"
#include "revisit_slam/types/session_offsets.h"

namespace revisit_slam {

/// The pose graph of a drive, or of several sessions: one node a scan, odometry edges between
/// consecutive scans of a session, loop edges between first scans of submaps, positions of GNSS in
/// a frame enu that is a node of its own, directions of gravity, and the poses of the last good
/// optimisation. It alone
/// knows which node of a PoseGraph stands for which scan. Sessions that loops do not tie to each
/// other have maps of their own (SessionGroups); loops that tie two for the first time bring the
/// later one into the map of the earlier. Positions of GNSS count in the map of the first session.
class SlamGraph {
 public:
  explicit SlamGraph(const BackEndConfig& config, const GnssConfig& gnss = {},
                     const GravityConfig& gravity = {})
      : config_(config), gnss_(gnss), gravity_(gravity) {}

  /// Takes effect with the next optimisation.
  void reconfigure(const BackEndConfig& config);

  /// @throws std::invalid_argument for an id that neither is the next one nor begins a session.
  void add(const GraphNode& node);

  /// Sessions that have been optimised already, before any node of others: their loops stay what
  /// they are, and those that were rejected are not tried again.
  void addOptimised(const std::vector<GraphNode>& nodes, const std::vector<Pose>& T_map_scan,
                    const std::vector<LoopEdge>& loops);

  /// What is in the map of the first session stays where it is from now on.
  void freezeMap();

  /// Optimises the graph up to scan `last` with new loops (none: once more with those it has). A
  /// solve that fails, and loops that override established ones, leave the last good poses; the new
  /// loops are then rejected. Then tries those that were rejected before, once each and all that
  /// came together at once, if the active loops or the configuration have changed since.
  /// @return whether the new loops were accepted.
  bool optimise(ScanId last, const std::vector<LoopConstraint>& new_loops);

  /// Leaves a loop out from the next optimisation on, for good. @return whether there was one,
  /// active or rejected, to leave out.
  bool disable(LoopId id);

  std::size_t size() const { return nodes_.size(); }
  const std::vector<GraphNode>& nodes() const { return nodes_; }
  const GraphNode& node(ScanId id) const { return nodes_.at(nodeOfScan(id).value); }
  const std::vector<LoopEdge>& loops() const { return loops_; }
  /// The pose of any scan, those after the last optimisation carried along by it.
  Pose pose(ScanId id) const;
  std::vector<Pose> poses() const;
  /// Of the newest session.
  Pose T_map_odom() const { return T_map_odom_; }

  /// Whether an optimisation up to this scan would have positions of GNSS or directions of gravity
  /// that are new.
  bool hasNewMeasurements(ScanId last) const {
    const std::size_t nodes = nodeOfScan(last).value + 1;
    return gnss_.hasNew(nodes) || gravity_.hasNew(nodes);
  }
  /// Where the map lies on the earth by the last optimisation.
  std::optional<Georeference> georeference() const { return gnss_.georeference(); }

  /// Of the last optimisation with new loops; its time includes that of trying rejected ones.
  const PoseGraphSolution& lastSolution() const { return last_solution_; }
  /// How far the last optimisation moved scan `last`, m.
  double movedEnd() const { return moved_end_; }

  /// All of it as a value, with the constraints that are active.
  PoseGraph graph() const { return graphUpTo(nodes_.size()).graph; }

 private:
  /// Loops that came together, by LoopId.
  struct Batch {
    std::size_t first = 0, end = 0;
    std::size_t tried_at = 0;  ///< changes_ when they were rejected

    bool contains(std::size_t loop) const { return first <= loop && loop < end; }
  };
  /// An active loop and the factor that stands for it.
  struct LoopFactor {
    std::size_t loop;
    FactorId factor;
  };
  struct LoopGraph {
    PoseGraph graph;
    std::size_t scans = 0;  // the first nodes
    std::vector<LoopFactor> loops;
    std::optional<GnssTerms> gnss;
  };

  NodeId nodeOfScan(ScanId id) const { return NodeId{static_cast<std::uint32_t>(scans_[id])}; }
  std::size_t nodesUpTo(ScanId last) const;
  void beginSession();
  void joinSessions(const Batch& batch);
  void moveGroup(const SessionGroups& groups, SessionId group, const Pose& T_new_map);
  RelativePoseFactor factorOf(const Constraint& constraint) const;
  RelativePoseFactor odometryEdge(std::size_t to) const;
  GnssFactors::IsInMap isInMap() const;
  LoopGraph graphUpTo(std::size_t nodes) const;
  std::vector<std::size_t> activeLoops() const;
  Batch append(const std::vector<LoopConstraint>& new_loops);
  bool isSuperseded(const LoopEdge& loop) const;
  std::size_t setState(const Batch& batch, LoopState from, LoopState to);
  bool tryBatch(ScanId last, Batch batch, PoseGraphSolution& solution);
  void tryRejected(ScanId last);
  bool isFrozen(const Constraint& constraint) const;
  bool overridesEstablishedLoops(const Batch& batch, const std::vector<LoopFactor>& active,
                                 const std::vector<FactorResidual>& residuals) const;
  void take(PoseGraphSolution& solution, const LoopGraph& solved);

  BackEndConfig config_;
  GnssFactors gnss_;
  GravityFactors gravity_;
  std::vector<GraphNode> nodes_;  // by NodeId
  SessionOffsets<ScanId> scans_;  // in nodes_
  std::vector<LoopEdge> loops_;   // by LoopId
  std::vector<Pose> optimised_;   // T_map_scan, by NodeId
  std::set<SessionId> frozen_;
  Pose T_map_odom_;                  // of the newest session
  PoseGraphSolution last_solution_;  // without its poses and factors
  double moved_end_ = 0.0;
  std::vector<Batch> rejected_;  // in the order in which they came
  std::size_t changes_ = 0;      // of the active loops and the configuration
};

}  // namespace revisit_slam
