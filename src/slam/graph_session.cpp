// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/graph_session.h"

#include <algorithm>
#include <ctime>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "revisit_slam/session/stored_submap.h"

namespace revisit_slam {
namespace {

/// `path`, with a number behind it if there is something of that name.
std::string freeName(const std::string& path) {
  std::string free = path;
  std::error_code ignored;
  for (int i = 2;
       std::filesystem::exists(free, ignored) && !std::filesystem::is_empty(free, ignored); ++i)
    free = path + "_" + std::to_string(i);
  return free;
}

/// FOLDER/2024-05-17_09-30-00 (UTC).
std::string nameOf(const std::string& folder, Stamp start) {
  const std::time_t seconds = start.nanoseconds / 1'000'000'000;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char name[32];
  std::strftime(name, sizeof(name), "%Y-%m-%d_%H-%M-%S", &utc);
  return folder + "/" + name;
}

SessionInfo infoOf(SessionId id, SlamConfig config, Stamp start, const std::string& sensor) {
  SessionInfo info;
  info.software = softwareVersion();
  info.id = id;
  info.start = start;
  info.map_frame = config.frames.map;
  info.odom_frame = config.frames.odom;
  info.base_frame = config.frames.base;
  info.sensor = sensor;
  info.parameters = textOf(parametersOf(config));
  return info;
}

}  // namespace

SessionTargets liveTargets(const LiveConfig& live, const std::string& sensor) {
  return [folder = live.folder, sensor](SessionId, Stamp start) {
    SessionTarget target;
    if (!folder.empty()) target.folder = freeName(nameOf(folder, start));
    target.sensor = sensor;
    return target;
  };
}

GraphSession::GraphSession(SessionId id, const SlamConfig& config, Stamp start,
                           const SessionTarget& target, OnCorrection on_correction)
    : id_(id),
      config_(config),
      info_(infoOf(id, config, start, target.sensor)),
      target_(target),
      graph_(config.backend),
      on_correction_(std::move(on_correction)) {
  if (!target_.folder.empty())
    writer_ = std::make_unique<SessionWriter>(target_, info_, config.background.niceness);
}

GraphSession::~GraphSession() = default;

void GraphSession::add(const GraphNode& node) {
  graph_.add(node);
  careForWriter();
  doWhatIsDue();
}

void GraphSession::add(const MapUpdatePtr& update) {
  submaps_.push_back(update->submap);
  occupancies_.push_back(update->occupancy);
  if (update->local_map) unsearched_.push_back(update->local_map);
  after(update->submap->lastScan().value + 1, [this, update] { log(update); });
}

void GraphSession::add(const LoopClosures& closures) {
  after(closures.last_scan.value + 1, [this, closures] {
    last_optimised_ = closures.last_scan;
    const auto searched = std::find_if(unsearched_.begin(), unsearched_.end(),
                                       [&](const auto& map) { return map->id == closures.map; });
    if (searched != unsearched_.end()) {
      local_maps_.push_back(storedLocalMap(**searched, closures.view.get()));
      unsearched_.erase(searched);
      if (writer_) writer_->add(local_maps_.back());
    }
    if (!closures.constraints.empty())
      optimise(closures.last_scan, closures.constraints, closures.request);
  });
}

void GraphSession::after(std::size_t scans, std::function<void()> work) {
  later_.push_back({scans, std::move(work)});
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

/// Answers in any case: the map manager waits for it.
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
  last_corrected_ = last;
  answer(last, request);
  logOptimisation(loops, disabled);
  if (error) std::rethrow_exception(error);
}

void GraphSession::answer(ScanId last, std::uint32_t request) {
  MapCorrection correction;
  correction.session = id_;
  correction.version = ++version_;
  correction.request = request;
  for (std::uint32_t i = 0; i <= last.value; ++i)
    correction.T_map_scan.push_back(graph_.pose({i, id_}));
  correction.T_map_odom = graph_.T_map_odom();
  correction.loops = graph_.loops();
  correction.moved_end = graph_.movedEnd();
  correction.seconds = graph_.lastSolution().seconds;
  on_correction_(std::make_shared<const MapCorrection>(std::move(correction)));
}

bool GraphSession::disable(LoopId id) {
  if (!graph_.disable(id)) return false;
  optimise(*last_optimised_, {}, 0, id);
  return true;
}

void GraphSession::reconfigure(const BackEndConfig& config) {
  graph_.reconfigure(config);
  config_.backend = config;
  if (!writer_) return;
  StoredParameters changed;
  changed.backend = config;
  ParametersChanged entry;
  for (const NamedText& value : textOf(parametersOf(changed)))
    if (value.first.rfind("backend/", 0) == 0) entry.values.push_back(value);
  writer_->add(LogEntry(entry));
}

std::vector<GraphNode> GraphSession::nodesFrom(std::size_t first, std::size_t end) const {
  const auto begin = graph_.nodes().begin();
  return {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end)};
}

void GraphSession::log(const MapUpdatePtr& update) {
  const std::size_t end = update->submap->lastScan().value + 1;
  closed_.push_back(closedOf(*update->submap, update->detail_submap));
  if (writer_) writer_->add(nodesFrom(logged_scans_, end), closed_.back(), update);
  logged_scans_ = end;
}

void GraphSession::logOptimisation(std::vector<LoopConstraint> loops,
                                   std::optional<LoopId> disabled) {
  if (!writer_) return;
  GraphOptimised entry = optimised(std::move(loops));
  entry.disabled = disabled;
  writer_->add(LogEntry(std::move(entry)));
}

GraphOptimised GraphSession::optimised(std::vector<LoopConstraint> new_loops) const {
  GraphOptimised entry;
  entry.version = version_;
  entry.last_scan = last_corrected_;
  entry.constraints = std::move(new_loops);
  entry.T_map_odom = graph_.T_map_odom();
  for (const SubmapClosed& submap : closed_)
    if (!(last_corrected_ < submap.first_scan))
      entry.T_map_keypose.push_back(graph_.pose(submap.first_scan));
  for (const LoopEdge& edge : graph_.loops())
    entry.decisions.push_back({edge.state, edge.chi2_before, edge.chi2_after, edge.weight});
  return entry;
}

TrajectoryWritten GraphSession::optimisedTrajectory() const {
  TrajectoryWritten entry;
  entry.version = version_;
  for (std::uint32_t i = 0; i <= last_corrected_.value; ++i)
    entry.T_map_scan.push_back(graph_.pose({i, id_}));
  return entry;
}

/// So that reading the session needs no solver.
void GraphSession::logTrajectory() {
  if (trajectory_version_ == version_) return;
  writer_->add(LogEntry(optimisedTrajectory()));
  trajectory_version_ = version_;
}

/// What could not be written is tried again about once a second; a folder that was removed is
/// written anew, from what is in memory.
void GraphSession::careForWriter() {
  constexpr std::size_t scans = 10;
  if (!writer_ || graph_.size() % scans != 0 || writer_->problem().empty()) return;
  if (!writer_->lost()) return writer_->retry();
  writer_->drain();
  SessionTarget target = target_;
  target.lock = nullptr;
  target.is_ours = true;
  auto anew = std::make_unique<SessionWriter>(target, info_, config_.background.niceness);
  writeAll(*anew, writer_.get());
  writer_ = std::move(anew);
}

/// As finely as there is something: where its file is gone, the points of a submap alone.
MapUpdatePtr GraphSession::stored(std::size_t submap, const SessionWriter* lost) const {
  const SubmapId id = submaps_[submap]->id;
  if (const SessionWriter* source = lost ? lost : writer_.get()) {
    const auto unwritten = source->unwritten().find(id);
    if (unwritten != source->unwritten().end()) return unwritten->second;
  }
  auto update = std::make_shared<MapUpdate>();
  update->submap = submaps_[submap];
  update->occupancy = occupancies_[submap];
  update->detail_submap = submaps_[submap]->points;
  try {
    if (writer_)
      update->detail_submap =
          readSubmap(submapFile(target_.folder, id), {SubmapRecord::detail}).detail_submap;
  } catch (const std::runtime_error&) {
  }
  return update;
}

void GraphSession::writeAll(SessionWriter& writer, const SessionWriter* lost) const {
  std::size_t scans = 0;
  for (std::size_t i = 0; i < closed_.size(); ++i) {
    const std::size_t end = closed_[i].last_scan.value + 1;
    writer.add(nodesFrom(scans, end), closed_[i], stored(i, lost));
    scans = end;
    if (!lost) writer.drain();  // one in memory at a time
  }
  for (const StoredLocalMap& map : local_maps_) writer.add(map);
  if (version_ == 0) return;
  std::vector<LoopConstraint> loops;
  for (const LoopEdge& edge : graph_.loops()) loops.push_back(edge.loop);
  writer.add(LogEntry(optimised(std::move(loops))));
  writer.add(LogEntry(optimisedTrajectory()));
}

Session GraphSession::snapshot() const {
  return {target_.folder, info_, closed_, graphOf(graph_)};
}

void GraphSession::requireWritten() {
  writer_->drain();
  if (!writer_->problem().empty()) throw std::runtime_error(writer_->problem());
}

std::vector<std::string> GraphSession::saveOwn(const ExportProgress& progress) {
  if (!writer_) return {};
  logTrajectory();
  if (isWhole()) writer_->close();
  requireWritten();
  return exportSession(snapshot(), target_.folder, {}, progress);
}

std::string GraphSession::save(const std::string& folder) {
  const std::string& live = config_.live.folder;
  if (folder.empty() || folder == target_.folder) {
    if (!writer_) throw std::runtime_error("no folder: give one, or set live/folder");
    saveOwn();
    return target_.folder;
  }
  const std::filesystem::path path = std::filesystem::path(folder).lexically_normal();
  const bool is_relative = path.is_relative();
  if (is_relative && (*path.begin() == ".." || path == "."))
    throw std::runtime_error("'" + folder + "' is not a folder within live/folder");
  if (is_relative && live.empty())
    throw std::runtime_error("'" + folder +
                             "' is relative: give an absolute folder, or set live/folder, in which "
                             "relative ones are");
  SessionTarget target;
  target.folder = freeName(is_relative ? live + "/" + path.string() : path.string());
  target.sensor = target_.sensor;
  if (writer_) writer_->drain();  // what is copied is on disk, or known to wait
  SessionWriter writer(target, info_, config_.background.niceness);
  writeAll(writer, nullptr);
  writer.add(LogEntry(ScansAdded{nodesFrom(logged_scans_, graph_.size())}));
  if (isWhole()) writer.close();
  writer.drain();
  if (!writer.problem().empty()) throw std::runtime_error(writer.problem());
  Session session = snapshot();
  session.folder = target.folder;
  exportSession(session, target.folder);
  return target.folder;
}

void GraphSession::writeRest() {
  if (!writer_) return;
  if (!isWhole()) writer_->add(LogEntry(ScansAdded{nodesFrom(logged_scans_, graph_.size())}));
  logTrajectory();
  if (isWhole()) writer_->close();
  requireWritten();
  ExportConfig graph_alone;
  graph_alone.clouds.clear();
  graph_alone.submaps = graph_alone.occupancy = false;
  exportSession(snapshot(), target_.folder, graph_alone);
}

void GraphSession::tell(RunSummary& summary) const {
  for (const LoopEdge& edge : graph_.loops())
    ++summary.loops[std::string(toString(edge.loop.origin)) + " " + toString(edge.state)];
  summary.optimisations = count_.optimisations;
  summary.rejected_optimisations = count_.rejected;
}

void GraphSession::writeSummary() const {
  if (!writer_) return;
  SlamConfig config = config_;
  RunSummary summary;
  summary.parameters = parametersOf(config);
  summary.account.received = summary.account.processed = graph_.size();
  summary.topic = target_.sensor;
  summary.tracked_frame = config_.frames.base;
  summary.threads = config_.odometry.threads;
  tell(summary);
  if (!graph_.nodes().empty()) {
    TravelledDistance distance;
    distance.start(graph_.nodes().front().T_odom_base.translation);
    for (const GraphNode& node : graph_.nodes()) distance.go(node.T_odom_base.translation);
    summary.path_length = distance.metres();
  }
  judge(consistencyOf(snapshot()), summary);
  writeRunSummary(target_.folder + "/run.json", summary, {});
}

std::size_t activeLoops(const SlamGraph& graph) {
  return static_cast<std::size_t>(
      std::count_if(graph.loops().begin(), graph.loops().end(),
                    [](const LoopEdge& edge) { return edge.state == LoopState::active; }));
}

}  // namespace revisit_slam
