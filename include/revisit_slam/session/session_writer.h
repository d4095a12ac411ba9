// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/io/folder_lock.h"
#include "revisit_slam/io/growing_file.h"
#include "revisit_slam/session/session_reader.h"
#include "revisit_slam/session/stored_local_map.h"
#include "revisit_slam/util/lane.h"

namespace revisit_slam {

struct KnownMap;

/// Where a session is written, and where its scans come from.
struct SessionTarget {
  std::string folder;                ///< empty: nowhere
  std::string sensor;                ///< for session.yaml
  std::shared_ptr<FolderLock> lock;  ///< null: the writer locks the folder itself
  bool is_ours = false;              ///< what is in the folder was written for this session
  std::shared_ptr<const KnownMap> prior =
      nullptr;  ///< what the session goes on from; null: nothing
};

/// What a disk has not taken yet: it is full, or slow.
struct WriterBacklog {
  std::size_t writes = 0;
  double seconds = 0.0;  ///< that the oldest of them has waited
};

/// Writes a session while it is driven, in a thread of its own, in the order in which it is told.
/// What cannot be written waits, and is tried again with whatever comes next: nobody else has to
/// care. Costs what is new, never what has been.
class SessionWriter {
 public:
  /// Makes the folder, where it can. `niceness` of the thread.
  SessionWriter(SessionTarget target, SessionInfo info, int niceness);
  ~SessionWriter();

  /// A submap that was closed, and the scans since the one before. `update` null: nothing is left
  /// of it but what the log tells.
  void add(std::vector<GraphNode> scans, const SubmapClosed& closed, const MapUpdatePtr& update);
  void add(const StoredLocalMap& map);
  void add(LogEntry entry);
  /// The datum of the frame enu, for session.yaml.
  void setDatum(const GeodeticPosition& datum);
  /// Every scan is in a submap that was added.
  void close();

  /// Tries again what waits.
  void retry();
  /// Returns when everything is tried, and handed to the disk.
  void drain();

  /// Why something waits to be written; empty: nothing does. Thread-safe.
  std::string problem() const;
  /// Thread-safe.
  WriterBacklog backlog() const;
  /// A log has been removed, with all that was in it. Thread-safe.
  bool lost() const { return lost_; }

  const std::string& folder() const { return target_.folder; }
  /// After drain(): submaps whose files are not written yet.
  const std::map<SubmapId, MapUpdatePtr>& unwritten() const { return unwritten_; }

 private:
  using Job = std::function<void()>;

  void post(Job job);
  void work();
  void begin();
  void beginLog(std::optional<GrowingFile>& log, const std::string& path);
  void setClosed(bool closed);
  void write(const std::string& path, const std::string& bytes);
  void noteProblem(const std::string& problem);

  SessionTarget target_;
  SessionInfo info_;

  mutable std::mutex mutex_;  // guards the next two
  std::string problem_;
  std::deque<std::chrono::steady_clock::time_point> posted_;  // when what waits was
  std::atomic<bool> lost_{false};

  // Of the thread.
  std::deque<Job> jobs_;
  std::map<SubmapId, MapUpdatePtr> unwritten_;
  std::optional<GrowingFile> log_, optimisations_;

  ThreadLane lane_;  // last: its thread uses the above
};

/// @throws std::runtime_error where a session, or files of one, are in the folder.
void requireUnused(const std::string& folder);

}  // namespace revisit_slam
