// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/slam_graph.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "revisit_slam/pose_graph/solver.h"

namespace revisit_slam {

void SlamGraph::reconfigure(const BackEndConfig& config) {
  config_ = config;
  ++changes_;
}

void SlamGraph::add(const GraphNode& node) {
  if (nodeOfScan(node.id).value != nodes_.size())
    throw std::invalid_argument("scan " + std::to_string(node.id.value) + " cannot follow " +
                                std::to_string(nodes_.size()) + " nodes");
  gnss_.add(nodes_.size(), node.fixes);
  nodes_.push_back(node);
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
  return factorOf({nodes_[to - 1].id, nodes_[to].id, T_from_to,
                   gnss_.isConnected() ? gnss_.loosened(information, T_from_to.translation.norm())
                                       : information});
}

SlamGraph::LoopGraph SlamGraph::graphUpTo(std::size_t nodes) const {
  LoopGraph result;
  PoseGraph& graph = result.graph;
  const std::vector<std::size_t> active = activeLoops();
  const bool is_corrected = !active.empty() || gnss_.georeference();
  for (std::size_t i = 0; i < nodes; ++i) {
    // Without loops nothing is left of what others that are now disabled have done.
    graph.addNode(is_corrected ? pose(nodes_[i].id) : nodes_[i].T_odom_base);
    if (i > 0) graph.addFactor(odometryEdge(i));
  }
  const RobustKernel kernel = config_.loop_kernel.value();
  for (const std::size_t i : active)
    result.loops.push_back({i, graph.addFactor(factorOf(loops_[i].loop.constraint), kernel)});
  result.gnss = gnss_.addTo(graph);
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

/// Whether these two submaps were registered anew, and that loop has been accepted.
bool SlamGraph::isSuperseded(std::size_t loop) const {
  const Constraint& old = loops_[loop].loop.constraint;
  return std::any_of(loops_.begin() + static_cast<std::ptrdiff_t>(loop) + 1, loops_.end(),
                     [&](const LoopEdge& edge) {
                       const Constraint& newer = edge.loop.constraint;
                       return edge.state == LoopState::active && newer.from == old.from &&
                              newer.to == old.to;
                     });
}

/// @return how many loops changed.
std::size_t SlamGraph::setState(const Batch& batch, LoopState from, LoopState to) {
  std::size_t changed = 0;
  for (std::size_t i = batch.first; i < batch.end; ++i) {
    if (loops_[i].state != from || (to == LoopState::active && isSuperseded(i))) continue;
    loops_[i].state = to;
    ++changed;
  }
  return changed;
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
  const LoopGraph graph = graphUpTo(nodeOfScan(last).value + 1);
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

/// Every loop has a vote: inliers of the batch against established loops that are inliers no
/// longer.
bool SlamGraph::overridesEstablishedLoops(const Batch& batch, const std::vector<LoopFactor>& active,
                                          const std::vector<FactorResidual>& residuals) const {
  const auto is_inlier = [&](double weight) { return weight >= config_.min_inlier_weight; };
  std::size_t added = 0, inliers = 0, overridden = 0;
  for (const auto& [loop, factor] : active) {
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
  if (solved.gnss) {
    gnss_.take(solution, *solved.gnss, config_.min_inlier_weight);
    solution.poses.pop_back();
  }
  const GraphNode& end = nodes_[solution.poses.size() - 1];
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
