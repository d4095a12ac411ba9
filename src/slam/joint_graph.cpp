// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/joint_graph.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "revisit_slam/loops/acceptance/session_joining.h"
#include "revisit_slam/types/session_groups.h"

namespace revisit_slam {
namespace {

SessionId sessionOf(std::size_t place) {
  return {static_cast<std::uint32_t>(place)};
}

/// With keyposes as its scans: from session `target` to session `source`.
LoopConstraint atKeyposes(LoopConstraint loop, SessionId target, SessionId source) {
  loop.target.session = loop.target_map.session = target;
  loop.source.session = loop.source_map.session = source;
  loop.constraint.from = {loop.target.value, target};
  loop.constraint.to = {loop.source.value, source};
  return loop;
}

LoopProposal acceptedProposal(const LoopConstraint& loop) {
  LoopProposal proposal;
  proposal.loop = loop;
  proposal.registered.registration.T_target_source = loop.constraint.T_from_to;
  proposal.registered.registration.fitness = loop.fitness;
  return proposal;
}

auto keyOf(const LoopConstraint& loop) {
  return std::tuple(loop.source, loop.target);
}

/// For what the odometry drifts.
std::vector<SubmapPtr> withoutScans(const std::vector<SessionSummary>& sessions) {
  std::vector<SubmapPtr> submaps;
  for (std::size_t s = 0; s < sessions.size(); ++s)
    for (const SummarisedSubmap& summarised : sessions[s].submaps) {
      auto submap = std::make_shared<Submap>();
      submap->id = {summarised.id.value, sessionOf(s)};
      submap->travelled_begin = summarised.travelled_begin;
      submap->unsure_begin = summarised.unsure_begin;
      submaps.push_back(std::move(submap));
    }
  return submaps;
}

}  // namespace

JointGraph::JointGraph(const SlamConfig& config, std::vector<SessionSummary> sessions,
                       const std::vector<SessionCrossing>& crossings)
    : config_(config), sessions_(std::move(sessions)), graph_(config.backend) {
  addSessions();
  hold(crossings);
  join();
  takeExpected();
}

void JointGraph::addSessions() {
  for (std::size_t s = 0; s < sessions_.size(); ++s) {
    std::vector<GraphNode> nodes;
    std::vector<Pose> T_map_submap;
    for (const SummarisedSubmap& submap : sessions_[s].submaps) {
      nodes.push_back({ScanId{submap.id.value, sessionOf(s)}, submap.stamp, submap.T_odom_submap,
                       submap.information});
      T_map_submap.push_back(submap.T_map_submap);
      offsets_.append(nodes.back().id);
    }
    std::vector<LoopEdge> loops = sessions_[s].loops;
    for (LoopEdge& edge : loops) edge.loop = atKeyposes(edge.loop, sessionOf(s), sessionOf(s));
    graph_.addOptimised(nodes, T_map_submap, loops);
  }
}

void JointGraph::hold(const std::vector<SessionCrossing>& crossings) {
  std::map<std::string, SessionId> by_name;
  for (std::size_t s = 0; s < sessions_.size(); ++s)
    if (!by_name.emplace(sessions_[s].name, sessionOf(s)).second)
      throw std::runtime_error("two sessions have the name '" + sessions_[s].name + "'");
  for (const SessionCrossing& crossing : crossings) {
    const auto target = by_name.find(crossing.target), source = by_name.find(crossing.source);
    if (target == by_name.end() || source == by_name.end()) continue;
    for (const LoopConstraint& loop : crossing.loops) {
      held_.push_back(acceptedProposal(atKeyposes(loop, target->second, source->second)));
      const Constraint& constraint = held_.back().loop.constraint;
      if (!offsets_.contains(constraint.from) || !offsets_.contains(constraint.to))
        throw std::runtime_error("a loop between '" + crossing.source + "' and '" +
                                 crossing.target + "' is of submaps that they do not have");
    }
  }
  std::sort(held_.begin(), held_.end(), [](const LoopProposal& a, const LoopProposal& b) {
    return keyOf(a.loop) < keyOf(b.loop);
  });
}

/// Those given to the graph are held no longer.
std::vector<LoopConstraint> JointGraph::takeHeld(const std::vector<std::size_t>& which) {
  std::vector<LoopConstraint> loops;
  for (const std::size_t i : which) loops.push_back(held_[i].loop);
  for (auto i = which.rbegin(); i != which.rend(); ++i)
    held_.erase(held_.begin() + static_cast<std::ptrdiff_t>(*i));
  return loops;
}

void JointGraph::join() {
  SessionJoining joining(config_.loops.joining, config_.loops.closer.consistency);
  for (const LoopProposal& proposal : held_) joining.hold(proposal);
  for (;; ++rounds_) {
    const std::vector<LoopProposal> believed =
        joining.takeBelieved(ScanPoses(graph_.poses(), offsets_), SessionGroups(graph_.loops()));
    if (believed.empty()) return;
    std::set<std::tuple<SubmapId, SubmapId>> keys;
    for (const LoopProposal& proposal : believed) keys.insert(keyOf(proposal.loop));
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < held_.size(); ++i)
      if (keys.count(keyOf(held_[i].loop)) > 0) which.push_back(i);
    takeHeld(which);
    graph_.optimise(graph_.nodes().back().id, acceptedOf(believed));
  }
}

/// Loops between sessions that are in one map by now, where the graph expects them.
std::vector<std::size_t> JointGraph::expected() const {
  const DriftConfig& drift = config_.loops.closer.drift;
  const SessionGroups groups(graph_.loops());
  const ScanPoses T_map_submap(graph_.poses(), offsets_);
  const GraphDrift between(withoutScans(sessions_), graph_.loops(), drift);
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const LoopConstraint& loop = held_[i].loop;
    if (!groups.areTied(loop.source.session, loop.target.session)) continue;
    const LoopPrior prior{
        T_map_submap[loop.constraint.from].inverse() * T_map_submap[loop.constraint.to],
        between.between(loop.source, loop.target)};
    if (drift.max_deviation <= 0.0 ||
        prior.deviation(loop.constraint.T_from_to, drift) <= drift.max_deviation)
      which.push_back(i);
  }
  return which;
}

/// All at once; where that would override what is established, those of two sessions at a time.
void JointGraph::takeExpected() {
  const std::vector<LoopConstraint> loops = takeHeld(expected());
  const ScanId last = graph_.nodes().back().id;
  if (loops.empty() || graph_.optimise(last, loops)) return;
  std::map<std::pair<SessionId, SessionId>, std::vector<LoopConstraint>> by_sessions;
  for (const LoopConstraint& loop : loops)
    by_sessions[{loop.source.session, loop.target.session}].push_back(loop);
  for (const auto& between : by_sessions) graph_.optimise(last, between.second);
}

std::vector<Pose> JointGraph::keyposes(std::size_t session) const {
  std::vector<Pose> T_map_submap;
  for (const SummarisedSubmap& submap : sessions_[session].submaps)
    T_map_submap.push_back(graph_.pose({submap.id.value, sessionOf(session)}));
  return T_map_submap;
}

std::size_t JointGraph::groupOf(std::size_t session) const {
  return SessionGroups(graph_.loops()).of(sessionOf(session)).value;
}

std::vector<LoopEdge> JointGraph::loopsBetweenSessions() const {
  std::vector<LoopEdge> loops;
  for (const LoopEdge& edge : graph_.loops())
    if (edge.loop.source.session != edge.loop.target.session) loops.push_back(edge);
  return loops;
}

Pose JointGraph::residual(const LoopEdge& edge) const {
  const Constraint& loop = edge.loop.constraint;
  return loop.T_from_to.inverse() * (graph_.pose(loop.from).inverse() * graph_.pose(loop.to));
}

}  // namespace revisit_slam
