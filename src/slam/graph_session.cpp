// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/graph_session.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include "revisit_slam/slam/map_correction.h"
#include "revisit_slam/types/session_groups.h"

namespace revisit_slam {
namespace {

/// With the sessions that were mapped before.
SlamGraph beginGraph(const SlamConfig& config, const KnownMapPtr& prior) {
  SlamGraph graph(config.backend, config.gnss, config.gravity);
  if (prior) graph.addOptimised(prior->nodes, prior->session.graph.T_map_scan, prior->loops);
  if (prior && config.backend.freeze_map) graph.freezeMap();
  return graph;
}

SlamConfig withDatumOf(const KnownMapPtr& prior, SlamConfig config) {
  if (prior) config.gnss = config.gnss.withDatumOf(prior->session.info.datum);
  return config;
}

}  // namespace

GraphSession::GraphSession(SessionId id, const SlamConfig& config, Stamp start,
                           const SessionTarget& target, OnCorrection on_correction)
    : id_(id),
      config_(withDatumOf(target.prior, config)),
      graph_(beginGraph(config_, target.prior)),
      scans_before_(graph_.size()),
      on_correction_(std::move(on_correction)),
      log_(id, config_, start, target, graph_) {
  if (scans_before_ > 0) last_optimised_ = graph_.nodes().back().id;
}

GraphSession::~GraphSession() = default;

void GraphSession::add(const GraphNode& node) {
  graph_.add(node);
  log_.careForWriter();
  doWhatIsDue();
}

void GraphSession::add(const MapUpdatePtr& update) {
  log_.keep(update);
  if (update->local_map) unsearched_.push_back(update->local_map);
  after(update->submap->lastScan().value + 1, [this, update] { log_.add(update); });
}

void GraphSession::add(const LoopClosures& closures) {
  after(closures.last_scan.value + 1, [this, closures] {
    try {
      take(closures);
    } catch (...) {  // the map manager waits for an answer
      if (closures.request != 0 && answered_ != closures.request)
        on_correction_(unchangedMap(id_, closures.request));
      throw;
    }
  });
}

void GraphSession::take(const LoopClosures& closures) {
  last_optimised_ = closures.last_scan;
  const auto searched = std::find_if(unsearched_.begin(), unsearched_.end(),
                                     [&](const auto& map) { return map->id == closures.map; });
  if (searched != unsearched_.end()) {
    log_.add(storedLocalMap(**searched, closures.view.get()));
    unsearched_.erase(searched);
  }
  if (!closures.constraints.empty() || graph_.hasNewMeasurements(closures.last_scan))
    optimise(closures.last_scan, closures.constraints, closures.request);
  else if (closures.request != 0)
    on_correction_(unchangedMap(id_, closures.request));
}

void GraphSession::after(std::size_t scans, std::function<void()> work) {
  later_.push_back({scans_before_ + scans, std::move(work)});
  doWhatIsDue();
}

/// All of it, whatever throws; the first that was thrown is thrown at the end.
void GraphSession::doWhatIsDue() {
  std::exception_ptr error;
  while (!later_.empty() && later_.front().scans <= graph_.size()) {
    const Later due = std::move(later_.front());
    later_.pop_front();
    try {
      due.work();
    } catch (...) {
      if (!error) error = std::current_exception();
    }
  }
  if (error) std::rethrow_exception(error);
}

void GraphSession::optimise(ScanId last, const std::vector<LoopConstraint>& loops,
                            std::uint32_t request, std::optional<LoopId> disabled) {
  std::exception_ptr error;
  try {
    const bool taken = graph_.optimise(last, loops);
    ++count_.optimisations;
    count_.seconds += graph_.lastSolution().seconds;
    if (!taken) ++count_.rejected;
  } catch (...) {
    error = std::current_exception();
  }
  answer(last, request);
  log_.add(version_, last, loops, disabled);
  if (error) std::rethrow_exception(error);
}

void GraphSession::answer(ScanId last, std::uint32_t request) {
  MapCorrection correction = correctionOf(graph_, last);
  correction.version = ++version_;
  correction.request = request;
  on_correction_(std::make_shared<const MapCorrection>(std::move(correction)));
  answered_ = request;
}

bool GraphSession::disable(LoopId id) {
  if (!graph_.disable(id)) return false;
  optimise(*last_optimised_, {}, 0, id);
  return true;
}

bool GraphSession::isPlaced() const {
  return scans_before_ == 0 ||
         SessionGroups(graph_.loops()).areTied(id_, graph_.nodes().front().id.session);
}

void GraphSession::reconfigure(const BackEndConfig& config) {
  graph_.reconfigure(config);
  config_.backend = config;
  log_.add(config);
}

std::vector<std::string> GraphSession::saveOwn(const ExportProgress& progress) {
  if (!log_.isWritten()) return {};
  log_.flush(false);
  return exportSession(snapshot(), folder(), {}, progress);
}

std::string GraphSession::save(const std::string& folder) {
  if (folder.empty() || folder == this->folder()) {
    if (!log_.isWritten()) throw std::runtime_error("no folder: give one, or set live/folder");
    saveOwn();
    return this->folder();
  }
  Session session = snapshot();
  session.folder = folderToSaveIn(folder, config_.live);
  log_.copyTo(session.folder);
  exportSession(session, session.folder);
  return session.folder;
}

void GraphSession::writeRest() {
  if (!log_.isWritten()) return;
  log_.flush(true);
  ExportConfig graph_alone;
  graph_alone.clouds.clear();
  graph_alone.submaps = graph_alone.occupancy = false;
  exportSession(snapshot(), folder(), graph_alone);
}

void GraphSession::tell(RunSummary& summary) const {
  for (const LoopEdge& edge : graph_.loops())
    ++summary.loops[std::string(toString(edge.loop.origin)) + " " + toString(edge.state)];
  summary.optimisations = count_.optimisations;
  summary.rejected_optimisations = count_.rejected;
}

void GraphSession::writeSummary(RunSummary summary) const {
  if (!log_.isWritten()) return;
  SlamConfig config = config_;
  summary.parameters = parametersOf(config);
  summary.topic = log_.sensor();
  summary.tracked_frame = config_.frames.base;
  summary.threads = config_.odometry.threads;
  tell(summary);
  judge(consistencyOf(snapshot()), summary);
  writeRunSummary(folder() + "/run.json", summary);
}

std::size_t activeLoops(const SlamGraph& graph) {
  return static_cast<std::size_t>(
      std::count_if(graph.loops().begin(), graph.loops().end(),
                    [](const LoopEdge& edge) { return edge.state == LoopState::active; }));
}

}  // namespace revisit_slam
