// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_reader.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

#include "revisit_slam/io/stored_pose.h"
#include "revisit_slam/types/session_groups.h"

namespace revisit_slam {
namespace {

/// Follows the log from entry to entry.
class LogReplay {
 public:
  LogReplay(const StoredParameters& parameters, bool with_solver)
      : backend_(parameters.backend),
        gnss_(parameters.gnss),
        gravity_(parameters.gravity),
        solver_(parameters.backend, parameters.gnss, parameters.gravity),
        with_solver_(with_solver) {}

  /// @throws std::runtime_error for an entry that does not follow those before.
  void take(const LogEntry& entry) {
    std::visit([this](const auto& what) { add(what); }, entry);
  }

  std::vector<SubmapClosed> submaps;
  SessionGraph graph;

  bool isExact() const { return exact_version_ == version_; }
  bool hasTakenOver() const { return has_taken_over_; }

  void placeScans() {
    graph.T_map_scan = isExact() ? T_map_scan_ : carriedByKeyposes();
    for (std::size_t i = graph.T_map_scan.size(); i < graph.nodes.size(); ++i)
      graph.T_map_scan.push_back(graph.T_map_odom * graph.nodes[i].T_odom_base);
  }

 private:
  bool isThere(ScanId scan) const { return scans_.contains(scan); }

  /// Whether a loop lies between submaps that are there.
  bool isBetweenSubmaps(const LoopConstraint& loop) const {
    const auto begins = [this](SubmapId id, LocalMapId map, ScanId scan) {
      if (!submap_order_.contains(id)) return false;
      const SubmapClosed& submap = submaps[submap_order_[id]];
      return submap.first_scan == scan && submap.local_map == map;
    };
    return loop.constraint.from != loop.constraint.to &&
           begins(loop.target, loop.target_map, loop.constraint.from) &&
           begins(loop.source, loop.source_map, loop.constraint.to);
  }

  void add(const SubmapClosed& submap) {
    const SessionId session = submap.id.session;
    const bool begins = submaps.empty() || submaps.back().id.session != session;
    const ScanId first{begins ? 0 : submaps.back().last_scan.value + 1, session};
    if (submap.first_scan != first || submap.last_scan < first ||
        submap.last_scan.session != session || !isThere(submap.first_scan) ||
        !isThere(submap.last_scan))
      throw std::runtime_error("submap " + std::to_string(submap.id.value) +
                               " does not follow what comes before");
    append(submap.id, submap_order_);
    const LocalMapId map = submap.local_map;
    const bool is_new = begins || submaps.back().local_map != map;
    if (map.session != session) throw std::runtime_error("a submap is in a map of another session");
    if (is_new) append(map, map_order_);
    submaps.push_back(submap);
  }

  template <typename Id>
  static void append(Id id, SessionOffsets<Id>& order) {
    try {
      order.append(id);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(error.what());
    }
  }

  void add(const ScansAdded& scans) {
    for (GraphNode node : scans.nodes) {
      append(node.id, scans_);
      const auto fixes = fixes_.find(node.id);
      if (fixes != fixes_.end()) node.fixes = fixes->second;
      const auto direction = directions_.find(node.id);
      if (direction != directions_.end()) node.gravity = direction->second;
      graph.nodes.push_back(node);
      if (with_solver_) solver_.add(node);
    }
  }

  void add(const FixesAdded& added) {
    fixes_.clear();
    for (const auto& [carrier, fix] : added.fixes) fixes_[carrier].push_back(fix);
  }

  void add(const DirectionsAdded& added) {
    directions_ = {added.directions.begin(), added.directions.end()};
  }

  void add(const MapGeoreferenced& entry) { graph.georeference = entry.georeference; }

  void add(const GraphOptimised& optimised) {
    const auto is_beyond = [&](const LoopConstraint& loop) {
      const ScanId from = loop.constraint.from, to = loop.constraint.to;
      return !isBetweenSubmaps(loop) ||
             std::max(scans_[from], scans_[to]) > scans_[optimised.last_scan];
    };
    if (!isThere(optimised.last_scan) ||
        (version_ > 0 && scans_[optimised.last_scan] < scans_[last_scan_]) ||
        std::any_of(optimised.constraints.begin(), optimised.constraints.end(), is_beyond) ||
        (optimised.disabled && optimised.disabled->value >= graph.loops.size()) ||
        optimised.decisions.size() != graph.loops.size() + optimised.constraints.size() ||
        optimised.T_map_keypose.size() > submaps.size())
      throw std::runtime_error("optimisation " + std::to_string(optimised.version) +
                               " does not follow what comes before");
    for (const LoopConstraint& loop : optimised.constraints) {
      LoopEdge edge;
      edge.id = LoopId{static_cast<std::uint32_t>(graph.loops.size())};
      edge.loop = loop;
      graph.loops.push_back(edge);
    }
    for (std::size_t i = 0; i < graph.loops.size(); ++i)
      decide(optimised.decisions[i], graph.loops[i]);
    graph.T_map_odom = optimised.T_map_odom;
    T_map_keypose_ = optimised.T_map_keypose;
    last_scan_ = optimised.last_scan;
    version_ = optimised.version;
    if (with_solver_) optimise(optimised);
  }

  /// What the graph did, once more: the same bytes, as long as it is the same software.
  void optimise(const GraphOptimised& optimised) {
    if (optimised.disabled) solver_.disable(*optimised.disabled);
    solver_.optimise(optimised.last_scan, optimised.constraints);
    for (std::size_t i = 0; i < T_map_keypose_.size(); ++i) {
      const Pose solved = solver_.pose(submaps[i].first_scan);
      if (solved.translation != T_map_keypose_[i].translation ||
          solved.rotation.coeffs() != T_map_keypose_[i].rotation.coeffs())
        return;
    }
    T_map_scan_.clear();
    for (std::size_t i = 0; i <= scans_[last_scan_]; ++i)
      T_map_scan_.push_back(solver_.pose(graph.nodes[i].id));
    exact_version_ = version_;
  }

  /// Nothing was known before it.
  void add(const SessionsTakenOver& taken) {
    const auto is_beyond = [&](const LoopEdge& edge) {
      const ScanId from = edge.loop.constraint.from, to = edge.loop.constraint.to;
      return !isBetweenSubmaps(edge.loop) ||
             std::max(scans_[from], scans_[to]) >= taken.T_map_scan.size();
    };
    if (taken.T_map_scan.empty() || taken.T_map_scan.size() > graph.nodes.size() ||
        !graph.loops.empty() || std::any_of(taken.loops.begin(), taken.loops.end(), is_beyond))
      throw std::runtime_error("the sessions taken over do not follow what comes before");
    has_taken_over_ = true;
    graph.loops = taken.loops;
    T_map_scan_ = taken.T_map_scan;
    const GraphNode& last = graph.nodes[taken.T_map_scan.size() - 1];
    if (last.id.session == graph.nodes.back().id.session)
      graph.T_map_odom = taken.T_map_scan.back() * last.T_odom_base.inverse();
    if (!with_solver_) return;
    const auto others = graph.nodes.begin() + static_cast<std::ptrdiff_t>(taken.T_map_scan.size());
    solver_ = SlamGraph(backend_, gnss_, gravity_);
    solver_.addOptimised({graph.nodes.begin(), others}, taken.T_map_scan, taken.loops);
    if (backend_.freeze_map) solver_.freezeMap();
    std::for_each(others, graph.nodes.end(), [&](const GraphNode& node) { solver_.add(node); });
  }

  void add(const TrajectoryWritten& trajectory) {
    if (trajectory.T_map_scan.size() > graph.nodes.size())
      throw std::runtime_error("a trajectory is longer than the drive");
    T_map_scan_ = trajectory.T_map_scan;
    exact_version_ = trajectory.version;
  }

  void add(const ParametersChanged& changed) {
    StoredParameters parameters;
    parameters.backend = backend_;
    assignKnown(parametersOf(parameters), changed.values);
    backend_ = parameters.backend;
    if (with_solver_) solver_.reconfigure(backend_);
  }

  /// Every scan where its keypose takes it.
  std::vector<Pose> carriedByKeyposes() const {
    std::vector<Pose> T_map_scan;
    for (std::size_t k = 0; k < T_map_keypose_.size(); ++k) {
      const std::size_t first = scans_[submaps[k].first_scan];
      const Pose T_map_odom = T_map_keypose_[k] * graph.nodes[first].T_odom_base.inverse();
      for (std::size_t i = first; i <= std::min(scans_[submaps[k].last_scan], scans_[last_scan_]);
           ++i)
        T_map_scan.push_back(i == first ? T_map_keypose_[k]
                                        : T_map_odom * graph.nodes[i].T_odom_base);
    }
    return T_map_scan;
  }

  BackEndConfig backend_;
  GnssConfig gnss_;
  GravityConfig gravity_;
  SlamGraph solver_;
  bool with_solver_;
  bool has_taken_over_ = false;
  std::uint32_t version_ = 0, exact_version_ = 0;  // of the last optimisation; of T_map_scan_
  ScanId last_scan_;
  // Of the scans that follow.
  std::map<ScanId, std::vector<GnssFix>> fixes_;
  std::map<ScanId, GravityDirection> directions_;
  std::vector<Pose> T_map_keypose_, T_map_scan_;
  SessionOffsets<ScanId> scans_;           // of graph.nodes
  SessionOffsets<SubmapId> submap_order_;  // of submaps
  SessionOffsets<LocalMapId> map_order_;   // of their local maps
};

/// Up to the first entry that does not follow those before.
LogReplay replayed(const GraphLog& log, const StoredParameters& parameters, bool with_solver,
                   std::string& problem) {
  LogReplay replay(parameters, with_solver);
  try {
    for (const LogEntry& entry : log.entries) replay.take(entry);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  return replay;
}

/// The drive, and then what the graph made of it: an optimisation looks at scans up to its last one
/// alone. In sessions of format 1 graph.log holds both. Of a session that is being written the
/// drive is read last: the graph is never ahead of it.
GraphLog readLogs(const std::string& folder, std::vector<std::string>& notices) {
  GraphLog optimisations;
  if (std::filesystem::exists(optimisationsFile(folder)))
    optimisations = readGraphLog(optimisationsFile(folder));
  GraphLog all = readGraphLog(graphLogFile(folder));
  for (const GraphLog* log : {&all, &optimisations})
    if (!log->damage.empty()) notices.push_back(log->damage);
  all.entries.insert(all.entries.end(), optimisations.entries.begin(), optimisations.entries.end());
  return all;
}

template <typename Id>
std::string numbered(const std::string& folder, int digits, Id id, SessionId owner) {
  char name[32];
  std::snprintf(name, sizeof(name), "%0*u.rsm", digits, id.value);
  return folder + (id.session == owner ? "" : std::to_string(id.session.value) + "_") + name;
}

}  // namespace

Session tiedTo(SessionId session, Session all) {
  const SessionGroups groups(all.graph.loops);
  const auto is_tied = [&](SessionId other) { return groups.areTied(session, other); };
  SessionGraph part;
  for (std::size_t i = 0; i < all.graph.nodes.size(); ++i) {
    if (!is_tied(all.graph.nodes[i].id.session)) continue;
    part.nodes.push_back(all.graph.nodes[i]);
    part.T_map_scan.push_back(all.graph.T_map_scan[i]);
  }
  if (!part.nodes.empty())
    part.T_map_odom = part.T_map_scan.back() * part.nodes.back().T_odom_base.inverse();
  if (!part.nodes.empty() && is_tied(all.graph.nodes.front().id.session))
    part.georeference = all.graph.georeference;
  for (LoopEdge edge : all.graph.loops) {
    if (!is_tied(edge.loop.source.session) || !is_tied(edge.loop.target.session)) continue;
    edge.id.value = static_cast<std::uint32_t>(part.loops.size());
    part.loops.push_back(edge);
  }
  all.graph = std::move(part);
  all.submaps.erase(std::remove_if(all.submaps.begin(), all.submaps.end(),
                                   [&](const auto& submap) { return !is_tied(submap.id.session); }),
                    all.submaps.end());
  return all;
}

std::vector<SessionId> sessionsOf(const Session& session) {
  return scansOf(session.graph).sessions();
}

StoredParameters storedParameters(const SessionInfo& info) {
  StoredParameters parameters;
  assignKnown(parametersOf(parameters), info.parameters);
  return parameters;
}

std::string graphLogFile(const std::string& folder) {
  return folder + "/graph.log";
}

std::string optimisationsFile(const std::string& folder) {
  return folder + "/optimisations.log";
}

std::string submapFile(const std::string& folder, SubmapId id, SessionId owner) {
  return numbered(folder + "/submaps/", 6, id, owner);
}

std::string localMapFile(const std::string& folder, LocalMapId id, SessionId owner) {
  return numbered(folder + "/local_maps/", 4, id, owner);
}

Session readSession(const std::string& folder, std::vector<std::string>& notices) {
  Session session;
  session.folder = folder;
  session.info = readSessionInfo(folder + "/session.yaml");
  const GraphLog log = readLogs(folder, notices);
  const StoredParameters parameters = storedParameters(session.info);
  std::string problem;
  LogReplay replay = replayed(log, parameters, false, problem);
  if (!replay.isExact()) replay = replayed(log, parameters, true, problem);
  if (!problem.empty())
    notices.push_back("the logs in '" + folder + "': " + problem + "; what follows is left out");
  if (!replay.isExact())
    notices.push_back(
        "this version optimises the graph differently from the one that wrote the session: "
        "keyposes are as stored, and the scans between them are moved with their keypose");
  if (!session.info.joined.empty() && !replay.hasTakenOver())
    notices.push_back(
        "the session in '" + folder +
        "' ended while the sessions that it goes on from were copied: it has neither "
        "their loops nor their corrected poses, which are where they were copied from");
  replay.placeScans();
  if (!std::all_of(replay.graph.T_map_scan.begin(), replay.graph.T_map_scan.end(), isPose))
    throw std::runtime_error("the session in '" + folder + "' cannot be used: a scan is nowhere");
  session.submaps = std::move(replay.submaps);
  session.graph = std::move(replay.graph);
  return session;
}

}  // namespace revisit_slam
