// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/slam_graph.h"

#include <algorithm>
#include <utility>

#include "revisit_slam/pose_graph/odometry_drift.h"
#include "revisit_slam/pose_graph/solver.h"

namespace revisit_slam {

void SlamGraph::reconfigure(const BackEndConfig& config) {
  config_ = config;
  ++changes_;
}

void SlamGraph::add(const GraphNode& node) {
  if (!nodes_.empty() && nodes_.back().id.session != node.id.session) beginSession();
  scans_.append(node.id);
  const std::size_t first = scans_.begin(node.id.session);
  gnss_.add(nodes_.size(), node.fixes, first);
  if (node.gravity) gravity_.add(nodes_.size(), *node.gravity, first);
  nodes_.push_back(node);
}

/// Its odometry begins a map of its own. Those before stay where they are.
void SlamGraph::beginSession() {
  optimised_ = poses();
  T_map_odom_ = Pose::identity();
}

void SlamGraph::addOptimised(const std::vector<GraphNode>& nodes,
                             const std::vector<Pose>& T_map_scan,
                             const std::vector<LoopEdge>& loops) {
  for (const GraphNode& node : nodes) add(node);
  optimised_ = poses();
  std::copy(T_map_scan.begin(), T_map_scan.end(),
            optimised_.end() - static_cast<std::ptrdiff_t>(nodes.size()));
  T_map_odom_ = optimised_.back() * nodes_.back().T_odom_base.inverse();
  for (LoopEdge edge : loops) {
    edge.id = LoopId{static_cast<std::uint32_t>(loops_.size())};
    loops_.push_back(edge);
  }
  ++changes_;
}

void SlamGraph::freezeMap() {
  const SessionGroups groups(loops_);
  for (const SessionId session : scans_.sessions())
    if (groups.areTied(nodes_.front().id.session, session)) frozen_.insert(session);
}

Pose SlamGraph::pose(ScanId id) const {
  const NodeId node = nodeOfScan(id);
  return node.value < optimised_.size() ? optimised_[node.value]
                                        : T_map_odom_ * nodes_.at(node.value).T_odom_base;
}

std::vector<Pose> SlamGraph::poses() const {
  std::vector<Pose> poses;
  poses.reserve(nodes_.size());
  for (const GraphNode& node : nodes_) poses.push_back(pose(node.id));
  return poses;
}

RelativePoseFactor SlamGraph::factorOf(const Constraint& constraint) const {
  return {{nodeOfScan(constraint.from), nodeOfScan(constraint.to)},
          constraint.T_from_to,
          constraint.information};
}

/// From the scan before to this one.
RelativePoseFactor SlamGraph::odometryEdge(std::size_t to) const {
  const Pose T_from_to = nodes_[to - 1].T_odom_base.inverse() * nodes_[to].T_odom_base;
  const Matrix6& information = nodes_[to].information;
  const bool is_held = gnss_.isConnected() || gravity_.any();
  return factorOf(
      {nodes_[to - 1].id, nodes_[to].id, T_from_to,
       is_held ? withDrift(information, T_from_to.translation.norm(), config_) : information});
}

GnssFactors::IsInMap SlamGraph::isInMap() const {
  return [this, groups = SessionGroups(loops_)](NodeId scan) {
    return groups.areTied(nodes_.front().id.session, nodes_[scan.value].id.session);
  };
}

SlamGraph::LoopGraph SlamGraph::graphUpTo(std::size_t nodes) const {
  LoopGraph result;
  PoseGraph& graph = result.graph;
  result.scans = nodes;
  const std::vector<std::size_t> active = activeLoops();
  const bool is_corrected = !active.empty() || gnss_.georeference() || gravity_.any();
  for (std::size_t i = 0; i < nodes; ++i) {
    const bool is_frozen = frozen_.count(nodes_[i].id.session) > 0;
    // Without loops nothing is left of what others that are now disabled have done.
    const bool stays = is_corrected || is_frozen;
    const NodeId node = graph.addNode(stays ? pose(nodes_[i].id) : nodes_[i].T_odom_base);
    if (is_frozen) graph.hold(node);
    if (i > 0 && nodes_[i].id.session == nodes_[i - 1].id.session) graph.addFactor(odometryEdge(i));
  }
  const RobustKernel kernel = config_.loop_kernel.value();
  for (const std::size_t i : active)
    result.loops.push_back({i, graph.addFactor(factorOf(loops_[i].loop.constraint), kernel)});
  const auto is_in_map = isInMap();
  result.gnss = gnss_.addTo(graph, is_in_map);
  std::optional<NodeId> level;
  if (result.gnss) level = result.gnss->enu;
  gravity_.addTo(graph, level, is_in_map);
  return result;
}

std::vector<std::size_t> SlamGraph::activeLoops() const {
  std::vector<std::size_t> active;
  for (std::size_t i = 0; i < loops_.size(); ++i)
    if (loops_[i].state == LoopState::active) active.push_back(i);
  return active;
}

SlamGraph::Batch SlamGraph::append(const std::vector<LoopConstraint>& new_loops) {
  Batch batch{loops_.size(), loops_.size() + new_loops.size()};
  for (const LoopConstraint& loop : new_loops) {
    LoopEdge edge;
    edge.id = LoopId{static_cast<std::uint32_t>(loops_.size())};
    edge.loop = loop;
    loops_.push_back(edge);
  }
  return batch;
}

/// Whether another registration of these two submaps has been accepted.
bool SlamGraph::isSuperseded(const LoopEdge& loop) const {
  const Constraint& ours = loop.loop.constraint;
  return std::any_of(loops_.begin(), loops_.end(), [&](const LoopEdge& other) {
    const Constraint& theirs = other.loop.constraint;
    return other.state == LoopState::active && other.id.value != loop.id.value &&
           theirs.from == ours.from && theirs.to == ours.to;
  });
}

/// @return how many loops changed.
std::size_t SlamGraph::setState(const Batch& batch, LoopState from, LoopState to) {
  std::size_t changed = 0;
  for (std::size_t i = batch.first; i < batch.end; ++i) {
    if (loops_[i].state != from || (to == LoopState::active && isSuperseded(loops_[i]))) continue;
    loops_[i].state = to;
    ++changed;
  }
  return changed;
}

/// Those of the newest session up to its last, and sessions before it wholly.
std::size_t SlamGraph::nodesUpTo(ScanId last) const {
  const SessionId newest = nodes_.back().id.session;
  return last.session == newest ? scans_[last] + 1 : scans_.begin(newest);
}

/// New loops between sessions that no others tie: the first of them says where the later session
/// lies in the map of the earlier one.
void SlamGraph::joinSessions(const Batch& batch) {
  if (scans_.sessions().size() < 2) return;
  std::vector<LoopEdge> others = loops_;
  for (std::size_t i = batch.first; i < batch.end; ++i) others[i].state = LoopState::rejected;
  SessionGroups groups(others);
  for (const SessionId session : frozen_) groups.join(*frozen_.begin(), session);
  for (std::size_t i = batch.first; i < batch.end; ++i) {
    const Constraint& loop = loops_[i].loop.constraint;
    const SessionId from = groups.of(loop.from.session), to = groups.of(loop.to.session);
    if (from == to || loops_[i].state != LoopState::active) continue;
    const Pose T_from_to = pose(loop.from) * loop.T_from_to * pose(loop.to).inverse();
    moveGroup(groups, std::max(from, to), from < to ? T_from_to : T_from_to.inverse());
    groups.join(from, to);
  }
}

void SlamGraph::moveGroup(const SessionGroups& groups, SessionId group, const Pose& T_new_map) {
  optimised_ = poses();
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (groups.of(nodes_[i].id.session) == group) optimised_[i] = T_new_map * optimised_[i];
  if (groups.of(nodes_.back().id.session) == group) T_map_odom_ = T_new_map * T_map_odom_;
}

bool SlamGraph::optimise(ScanId last, const std::vector<LoopConstraint>& new_loops) {
  const Eigen::Vector3d end_before = pose(last).translation;
  const bool accepted = tryBatch(last, append(new_loops), last_solution_);
  tryRejected(last);
  moved_end_ = (pose(last).translation - end_before).norm();
  return accepted;
}

/// Optimises with the active loops, among them those of the batch, and takes the new poses, or else
/// rejects the batch.
bool SlamGraph::tryBatch(ScanId last, Batch batch, PoseGraphSolution& solution) {
  const std::vector<Pose> optimised_before = optimised_;
  const Pose T_map_odom_before = T_map_odom_;
  joinSessions(batch);
  gnss_.placeOrigin(nodesUpTo(last), isInMap());
  const LoopGraph graph = graphUpTo(nodesUpTo(last));
  solution = solve(graph.graph, config_.solver);
  std::size_t added = 0;
  for (const auto& [loop, factor] : graph.loops) {
    if (!batch.contains(loop)) continue;
    loops_[loop].chi2_before = solution.factors[factor.value].chi2_before;
    ++added;
  }
  const bool good =
      solution.outcome == SolveOutcome::no_loops ||
      (solution.usable() && !overridesEstablishedLoops(batch, graph.loops, solution.factors));
  if (good) {
    take(solution, graph);
    if (added > 0) ++changes_;
  } else if (added > 0) {
    optimised_ = optimised_before;
    T_map_odom_ = T_map_odom_before;
    setState(batch, LoopState::active, LoopState::rejected);
    batch.tried_at = changes_;
    rejected_.push_back(batch);
  }
  solution.poses.clear();
  solution.factors.clear();
  return good;
}

/// Right loops are rejected when wrong ones came first, or with wrong ones. What came together is
/// tried together, in order; one solve for each, and none where it can only end as before.
void SlamGraph::tryRejected(ScanId last) {
  const std::vector<Batch> batches = std::exchange(rejected_, {});
  for (const Batch& batch : batches) {
    if (batch.tried_at == changes_) {
      rejected_.push_back(batch);
      continue;
    }
    if (setState(batch, LoopState::rejected, LoopState::active) == 0) continue;  // all out for good
    PoseGraphSolution solution;
    tryBatch(last, batch, solution);
    last_solution_.seconds += solution.seconds;
  }
}

bool SlamGraph::isFrozen(const Constraint& constraint) const {
  return frozen_.count(constraint.from.session) > 0 && frozen_.count(constraint.to.session) > 0;
}

/// Every loop that poses can follow has a vote: inliers of the batch against established loops that
/// are inliers no longer.
bool SlamGraph::overridesEstablishedLoops(const Batch& batch, const std::vector<LoopFactor>& active,
                                          const std::vector<FactorResidual>& residuals) const {
  const auto is_inlier = [&](double weight) { return weight >= config_.min_inlier_weight; };
  std::size_t added = 0, inliers = 0, overridden = 0;
  for (const auto& [loop, factor] : active) {
    if (isFrozen(loops_[loop].loop.constraint)) continue;
    const bool inlier = is_inlier(residuals[factor.value].weight);
    if (batch.contains(loop)) {
      ++added;
      if (inlier) ++inliers;
    } else if (is_inlier(loops_[loop].weight) && !inlier) {
      ++overridden;
    }
  }
  return added > 0 && (inliers == 0 || overridden > inliers);
}

void SlamGraph::take(PoseGraphSolution& solution, const LoopGraph& solved) {
  for (const auto& [loop, factor] : solved.loops) {
    loops_[loop].chi2_after = solution.factors[factor.value].chi2_after;
    loops_[loop].weight = solution.factors[factor.value].weight;
  }
  if (solved.gnss) gnss_.take(solution, *solved.gnss, config_.min_inlier_weight);
  gravity_.take(solved.scans);
  solution.poses.resize(solved.scans);  // those of frames are behind
  const GraphNode& end = nodes_[solution.poses.size() - 1];
  if (end.id.session == nodes_.back().id.session)
    T_map_odom_ = solution.poses.back() * end.T_odom_base.inverse();
  optimised_ = std::move(solution.poses);
}

bool SlamGraph::disable(LoopId id) {
  if (id.value >= loops_.size() || loops_[id.value].state == LoopState::disabled) return false;
  if (loops_[id.value].state == LoopState::active) ++changes_;
  loops_[id.value].state = LoopState::disabled;
  loops_[id.value].weight = 0.0;
  return true;
}

}  // namespace revisit_slam
