// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_writer.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/session/stored_submap.h"

namespace revisit_slam {
namespace {

void makeFolder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error("cannot make the folder '" + path + "': " + error.message());
}

/// The points and normals of a submap.
Submap surfaceIn(const std::string& file) {
  return *readSubmap(file, {SubmapRecord::points, SubmapRecord::normals}).submap;
}

}  // namespace

SessionWriter::SessionWriter(SessionTarget target, SessionInfo info, int niceness)
    : target_(std::move(target)),
      info_(std::move(info)),
      lane_(niceness, [this](const std::exception_ptr&) { noteProblem("out of memory"); }) {
  post([this] { begin(); });
}

SessionWriter::~SessionWriter() {
  drain();
}

/// A job that fails stays the first; it may have been done in part and is done again.
void SessionWriter::post(Job job) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    posted_.push_back(std::chrono::steady_clock::now());
  }
  lane_.post([this, job = std::move(job)]() mutable {
    jobs_.push_back(std::move(job));
    work();
  });
}

void SessionWriter::work() {
  try {
    while (!jobs_.empty()) {
      jobs_.front()();
      jobs_.pop_front();
      const std::lock_guard<std::mutex> lock(mutex_);
      posted_.pop_front();
    }
    noteProblem("");
  } catch (const std::exception& error) {
    noteProblem(error.what());
    for (const auto* log : {&log_, &optimisations_})
      if (*log && (*log)->removed()) lost_ = true;
  }
}

void SessionWriter::retry() {
  lane_.post([this] { work(); });
}

void SessionWriter::drain() {
  retry();
  lane_.drain();
}

void SessionWriter::noteProblem(const std::string& problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  problem_ = problem;
}

std::string SessionWriter::problem() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return problem_;
}

WriterBacklog SessionWriter::backlog() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (posted_.empty()) return {};
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - posted_.front();
  return {posted_.size(), waited.count()};
}

void SessionWriter::begin() {
  const std::string& folder = target_.folder;
  makeFolder(folder);
  if (!target_.is_ours) requireUnused(folder);
  target_.is_ours = true;
  if (!target_.lock) target_.lock = std::make_shared<FolderLock>(folder);
  makeFolder(folder + "/submaps");
  makeFolder(folder + "/local_maps");
  writeSessionInfo(folder + "/session.yaml", info_);
  beginLog(optimisations_, optimisationsFile(folder));
  beginLog(log_, graphLogFile(folder));
}

/// May be tried again, at whatever step it failed.
void SessionWriter::beginLog(std::optional<GrowingFile>& log, const std::string& path) {
  if (!log) log.emplace(path);
  if (log->size() > 0) return;
  log->append(graphLogHeader());
  log->sync();  // else the first entry that cannot be synced would take the header with it
}

void SessionWriter::write(const std::string& path, const std::string& bytes) {
  makeFolder(std::filesystem::path(path).parent_path().string());
  writeWholeText(path, bytes);
}

void SessionWriter::add(std::vector<GraphNode> scans, const SubmapClosed& closed,
                        const MapUpdatePtr& update) {
  const SubmapId id = closed.id;
  if (update) lane_.post([this, id, update] { unwritten_[id] = update; });
  const LogEntry nodes = ScansAdded{std::move(scans)};
  post([this, id, closed, update, nodes] {
    setClosed(false);
    const std::string file = submapFile(target_.folder, id, info_.id);
    if (update) write(file, encodeSubmap(*update));
    log_->append(encodeEntry(nodes) + encodeEntry(closed));
    log_->sync();
    unwritten_.erase(id);
    if (update && update->library)
      update->library->noteStored(id, [file] { return surfaceIn(file); });
  });
}

void SessionWriter::add(const StoredLocalMap& map) {
  post([this, map] { write(localMapFile(target_.folder, map.id, info_.id), encodeLocalMap(map)); });
}

void SessionWriter::add(LogEntry entry) {
  post([this, entry = std::move(entry)] {
    GrowingFile& log = belongsToDrive(entry) ? *log_ : *optimisations_;
    log.append(encodeEntry(entry));
    log.sync();
  });
}

void SessionWriter::setDatum(const GeodeticPosition& datum) {
  post([this, datum] {
    if (info_.datum && areEqual(*info_.datum, datum)) return;
    SessionInfo info = info_;
    info.datum = datum;
    writeSessionInfo(target_.folder + "/session.yaml", info);
    info_ = info;
  });
}

void SessionWriter::close() {
  post([this] { setClosed(true); });
}

void SessionWriter::setClosed(bool closed) {
  if (info_.closed == closed) return;
  SessionInfo info = info_;
  info.closed = closed;
  writeSessionInfo(target_.folder + "/session.yaml", info);
  info_ = info;
}

void requireUnused(const std::string& folder) {
  for (const char* name :
       {"session.yaml", "graph.log", "optimisations.log", "submaps", "local_maps", "run.json",
        "odometry.tum", "odometry_information.csv", "scan_times.csv", "localized.tum",
        "localization.csv", "trajectory.tum", "pose_graph.g2o", "map.pcd", "map.ply", "map.las",
        "map.bt", "map.pgm", "map_tiles"})
    if (std::filesystem::exists(folder + "/" + name))
      throw std::runtime_error("the folder '" + folder + "' holds results already (" + name +
                               "), which are not overwritten: give another one, or remove them");
}

}  // namespace revisit_slam
