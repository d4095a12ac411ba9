// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_reader.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

namespace revisit_slam {
namespace {

/// Follows the log from entry to entry.
class LogReplay {
 public:
  LogReplay(const StoredParameters& parameters, bool with_solver)
      : backend_(parameters.backend),
        solver_(parameters.backend, parameters.gnss),
        with_solver_(with_solver) {}

  /// @throws std::runtime_error for an entry that does not follow those before.
  void take(const LogEntry& entry) {
    std::visit([this](const auto& what) { add(what); }, entry);
  }

  std::vector<SubmapClosed> submaps;
  SessionGraph graph;

  bool isExact() const { return exact_version_ == version_; }

  void placeScans() {
    graph.T_map_scan = isExact() ? T_map_scan_ : carriedByKeyposes();
    for (std::size_t i = graph.T_map_scan.size(); i < graph.nodes.size(); ++i)
      graph.T_map_scan.push_back(graph.T_map_odom * graph.nodes[i].T_odom_base);
  }

 private:
  bool isThere(ScanId scan) const {
    return scan.value < graph.nodes.size() && scan.session == graph.nodes.front().id.session;
  }

  void add(const SubmapClosed& submap) {
    const std::uint32_t first = submaps.empty() ? 0 : submaps.back().last_scan.value + 1;
    if (submap.id.value != submaps.size() || submap.first_scan.value != first ||
        submap.last_scan.value < first || !isThere(submap.first_scan) || !isThere(submap.last_scan))
      throw std::runtime_error("submap " + std::to_string(submap.id.value) +
                               " does not follow what comes before");
    submaps.push_back(submap);
  }

  void add(const ScansAdded& scans) {
    for (GraphNode node : scans.nodes) {
      const bool is_first = graph.nodes.empty();
      if (node.id.value != graph.nodes.size() ||
          (!is_first && node.id.session != graph.nodes.front().id.session))
        throw std::runtime_error("scan " + std::to_string(node.id.value) +
                                 " does not follow what comes before");
      const auto fixes = fixes_.find(node.id);
      if (fixes != fixes_.end()) node.fixes = fixes->second;
      graph.nodes.push_back(node);
      if (with_solver_) solver_.add(node);
    }
  }

  void add(const FixesAdded& added) {
    fixes_.clear();
    for (const auto& [carrier, fix] : added.fixes) fixes_[carrier].push_back(fix);
  }

  void add(const MapGeoreferenced& entry) { graph.georeference = entry.georeference; }

  void add(const GraphOptimised& optimised) {
    const auto is_beyond = [&](const LoopConstraint& loop) {
      const ScanId from = loop.constraint.from, to = loop.constraint.to;
      return !isThere(from) || !isThere(to) || from == to || optimised.last_scan < from ||
             optimised.last_scan < to;
    };
    if (!isThere(optimised.last_scan) ||
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
    for (std::size_t i = 0; i < graph.loops.size(); ++i) {
      const GraphOptimised::Decision& decision = optimised.decisions[i];
      graph.loops[i].state = decision.state;
      graph.loops[i].chi2_before = decision.chi2_before;
      graph.loops[i].chi2_after = decision.chi2_after;
      graph.loops[i].weight = decision.weight;
    }
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
    for (std::uint32_t i = 0; i <= last_scan_.value; ++i)
      T_map_scan_.push_back(solver_.pose(ScanId{i, last_scan_.session}));
    exact_version_ = version_;
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
      const Pose T_map_odom =
          T_map_keypose_[k] * graph.nodes[submaps[k].first_scan.value].T_odom_base.inverse();
      for (std::uint32_t i = submaps[k].first_scan.value;
           i <= std::min(submaps[k].last_scan.value, last_scan_.value); ++i)
        T_map_scan.push_back(i == submaps[k].first_scan.value
                                 ? T_map_keypose_[k]
                                 : T_map_odom * graph.nodes[i].T_odom_base);
    }
    return T_map_scan;
  }

  BackEndConfig backend_;
  SlamGraph solver_;
  bool with_solver_;
  std::uint32_t version_ = 0, exact_version_ = 0;  // of the last optimisation; of T_map_scan_
  ScanId last_scan_;
  std::map<ScanId, std::vector<GnssFix>> fixes_;  // of the scans that follow
  std::vector<Pose> T_map_keypose_, T_map_scan_;
};

/// Up to the first entry that does not follow those before.
LogReplay replayed(const GraphLog& log, const StoredParameters& parameters, bool with_solver,
                   std::string& problem) {
  LogReplay replay(parameters, with_solver);
  try {
    for (const LogEntry& entry : log.entries) replay.take(entry);
  } catch (const std::runtime_error& error) {
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

std::string numbered(const std::string& folder, const char* format, std::uint32_t number) {
  char name[32];
  std::snprintf(name, sizeof(name), format, number);
  return folder + name;
}

}  // namespace

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

std::string submapFile(const std::string& folder, SubmapId id) {
  return numbered(folder, "/submaps/%06u.rsm", id.value);
}

std::string localMapFile(const std::string& folder, LocalMapId id) {
  return numbered(folder, "/local_maps/%04u.rsm", id.value);
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
        "this software optimises otherwise than the one that wrote the session: keyposes are as "
        "they were, and scans between them lie where their keypose takes them");
  replay.placeScans();
  session.submaps = std::move(replay.submaps);
  session.graph = std::move(replay.graph);
  return session;
}

}  // namespace revisit_slam
