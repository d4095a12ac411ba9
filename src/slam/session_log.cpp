// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/session_log.h"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "revisit_slam/session/stored_submap.h"
#include "revisit_slam/slam/map_correction.h"

namespace revisit_slam {
namespace {

SessionInfo infoOf(SessionId id, SlamConfig config, Stamp start, const SessionTarget& target) {
  SessionInfo info;
  if (target.prior) {
    info = infoOfAll({target.prior.get()});
    info.joined.push_back({id, start, target.sensor, ""});
  } else {
    info.id = id;
    info.start = start;
    info.sensor = target.sensor;
  }
  info.software = softwareVersion();
  info.map_frame = config.frames.map;
  info.odom_frame = config.frames.odom;
  info.base_frame = config.frames.base;
  info.parameters = textOf(parametersOf(config));
  return info;
}

/// Throws where something could not be written.
void requireWritten(SessionWriter& writer) {
  writer.drain();
  if (!writer.problem().empty()) throw std::runtime_error(writer.problem());
}

}  // namespace

SessionLog::SessionLog(SessionId id, const SlamConfig& config, Stamp start,
                       const SessionTarget& target, const SlamGraph& graph)
    : graph_(graph),
      niceness_(config.background.niceness),
      target_(target),
      info_(infoOf(id, config, start, target)),
      scans_before_(graph.size()),
      logged_scans_(graph.size()) {
  if (target_.prior)
    for (const SubmapClosed& closed : target_.prior->session.submaps)
      closed_before_.push_back(target_.prior->numbers(closed));
  if (target_.folder.empty()) return;
  writer_ = std::make_unique<SessionWriter>(target_, info_, niceness_);
  writePrior(*writer_, true);
}

void SessionLog::writePrior(SessionWriter& writer, bool reads_copies) const {
  if (!target_.prior) return;
  copyMaps(*target_.prior, writer, reads_copies);
  writer.add(
      LogEntry(SessionsTakenOver{target_.prior->loops, target_.prior->session.graph.T_map_scan}));
  if (const auto& known = target_.prior->session.graph.georeference)
    writer.add(LogEntry(MapGeoreferenced{0, *known}));
}

void SessionLog::keep(const MapUpdatePtr& update) {
  if (update->library)
    library_ = update->library;
  else
    library_->add(update->submap, update->occupancy);
  submaps_.push_back(library_->light(update->submap->id));
}

SubmapOccupancyPtr SessionLog::occupancy(const Submap& submap) const {
  if (SubmapOccupancyPtr in_memory = library_->occupancyInMemory(submap.id)) return in_memory;
  if (!writer_) return nullptr;
  try {
    return readSubmap(submapFile(target_.folder, submap.id, info_.id), {SubmapRecord::occupancy})
        .occupancy;
  } catch (const std::runtime_error&) {
    return nullptr;
  }
}

void SessionLog::add(const MapUpdatePtr& update) {
  const std::size_t end = scans_before_ + update->submap->lastScan().value + 1;
  closed_.push_back(closedOf(*update->submap, update->detail_submap));
  if (writer_) writer_->add(nodesFrom(logged_scans_, end), closed_.back(), update);
  logged_scans_ = end;
}

void SessionLog::add(StoredLocalMap map) {
  local_maps_.push_back(std::move(map));
  if (writer_) writer_->add(local_maps_.back());
}

void SessionLog::add(std::uint32_t version, ScanId last, std::vector<LoopConstraint> new_loops,
                     std::optional<LoopId> disabled) {
  version_ = version;
  last_corrected_ = last;
  if (!writer_) return;
  GraphOptimised entry = optimised(std::move(new_loops));
  entry.disabled = disabled;
  writer_->add(LogEntry(std::move(entry)));
  writeGeoreference(*writer_);
}

void SessionLog::writeGeoreference(SessionWriter& writer) const {
  const std::optional<Georeference> georeference = graph_.georeference();
  if (!georeference) return;
  writer.add(LogEntry(MapGeoreferenced{version_, *georeference}));
  writer.setDatum(georeference->datum);
}

void SessionLog::add(const BackEndConfig& changed) {
  if (!writer_) return;
  StoredParameters parameters;
  parameters.backend = changed;
  ParametersChanged entry;
  for (const NamedText& value : textOf(parametersOf(parameters)))
    if (value.first.rfind("backend/", 0) == 0) entry.values.push_back(value);
  writer_->add(LogEntry(entry));
}

std::vector<GraphNode> SessionLog::nodesFrom(std::size_t first, std::size_t end) const {
  const auto begin = graph_.nodes().begin();
  return {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end)};
}

GraphOptimised SessionLog::optimised(std::vector<LoopConstraint> new_loops) const {
  GraphOptimised entry;
  entry.version = version_;
  entry.last_scan = last_corrected_;
  entry.constraints = std::move(new_loops);
  entry.T_map_odom = graph_.T_map_odom();
  for (const auto* submaps : {&closed_before_, &closed_})
    for (const SubmapClosed& submap : *submaps)
      if (!(last_corrected_ < submap.first_scan))
        entry.T_map_keypose.push_back(graph_.pose(submap.first_scan));
  for (const LoopEdge& edge : graph_.loops()) entry.decisions.push_back(decisionOf(edge));
  return entry;
}

TrajectoryWritten SessionLog::optimisedTrajectory() const {
  TrajectoryWritten entry;
  entry.version = version_;
  entry.T_map_scan = correctionOf(graph_, last_corrected_).T_map_scan;
  return entry;
}

/// So that reading the session needs no solver.
void SessionLog::addTrajectory() {
  if (trajectory_version_ == version_) return;
  writer_->add(LogEntry(optimisedTrajectory()));
  trajectory_version_ = version_;
}

void SessionLog::careForWriter() {
  constexpr std::size_t scans = 10;
  if (!writer_ || graph_.size() % scans != 0 || writer_->problem().empty()) return;
  if (!writer_->lost()) return writer_->retry();
  writer_->drain();
  for (const std::string& log : {graphLogFile(target_.folder), optimisationsFile(target_.folder)}) {
    std::error_code ignored;
    std::filesystem::remove(log, ignored);  // one alone says too little
  }
  SessionTarget target = target_;
  target.lock = nullptr;
  target.is_ours = true;
  auto anew = std::make_unique<SessionWriter>(target, info_, niceness_);
  writeAll(*anew, writer_.get());
  writer_ = std::move(anew);
}

/// As finely as there is something: where its file is gone, the points of a submap alone; null
/// where these are not in memory either.
MapUpdatePtr SessionLog::stored(std::size_t submap, const SessionWriter* lost) const {
  const SubmapId id = submaps_[submap]->id;
  if (const SessionWriter* source = lost ? lost : writer_.get()) {
    const auto unwritten = source->unwritten().find(id);
    if (unwritten != source->unwritten().end()) {
      if (lost) return unwritten->second;
      auto copy = std::make_shared<MapUpdate>(*unwritten->second);
      copy->library = nullptr;  // it is told of the session's own folder alone
      return copy;
    }
  }
  try {
    if (writer_)
      return std::make_shared<const MapUpdate>(
          readSubmap(submapFile(target_.folder, id, info_.id),
                     {SubmapRecord::trajectory, SubmapRecord::points, SubmapRecord::normals,
                      SubmapRecord::detail, SubmapRecord::occupancy, SubmapRecord::sightings,
                      SubmapRecord::intensities}));
  } catch (const std::runtime_error&) {
  }
  auto update = std::make_shared<MapUpdate>();
  update->submap = library_->inMemory(id);
  if (!update->submap) return nullptr;
  update->occupancy = library_->occupancyInMemory(id);
  update->detail_submap = update->submap->points;
  return update;
}

std::size_t SessionLog::loopsBefore() const {
  return target_.prior ? target_.prior->loops.size() : 0;
}

void SessionLog::writeAll(SessionWriter& writer, const SessionWriter* lost) const {
  writePrior(writer, lost != nullptr);
  std::size_t scans = scans_before_;
  for (std::size_t i = 0; i < closed_.size(); ++i) {
    const std::size_t end = scans_before_ + closed_[i].last_scan.value + 1;
    writer.add(nodesFrom(scans, end), closed_[i], stored(i, lost));
    scans = end;
    if (!lost) writer.drain();  // one in memory at a time
  }
  for (const StoredLocalMap& map : local_maps_) writer.add(map);
  if (version_ == 0) return;
  std::vector<LoopConstraint> loops;
  for (std::size_t i = loopsBefore(); i < graph_.loops().size(); ++i)
    loops.push_back(graph_.loops()[i].loop);
  writer.add(LogEntry(optimised(std::move(loops))));
  writeGeoreference(writer);
  writer.add(LogEntry(optimisedTrajectory()));
}

Session SessionLog::snapshot() const {
  std::vector<SubmapClosed> submaps = closed_before_;
  submaps.insert(submaps.end(), closed_.begin(), closed_.end());
  SessionGraph graph = graphOf(graph_);
  // Before the first optimisation the map lies where it was.
  if (!graph.georeference && target_.prior)
    graph.georeference = target_.prior->session.graph.georeference;
  return {target_.folder, info_, std::move(submaps), std::move(graph)};
}

void SessionLog::flush(bool open_scans) {
  if (!writer_) return;
  if (open_scans && !isWhole())
    writer_->add(LogEntry(ScansAdded{nodesFrom(logged_scans_, graph_.size())}));
  addTrajectory();
  if (isWhole()) writer_->close();
  requireWritten(*writer_);
}

void SessionLog::copyTo(const std::string& folder) {
  if (writer_) writer_->drain();  // what is copied is on disk, or known to wait
  SessionWriter writer({folder, target_.sensor, nullptr, false, nullptr}, info_, niceness_);
  writeAll(writer, nullptr);
  writer.add(LogEntry(ScansAdded{nodesFrom(logged_scans_, graph_.size())}));
  if (isWhole()) writer.close();
  requireWritten(writer);
}

}  // namespace revisit_slam
