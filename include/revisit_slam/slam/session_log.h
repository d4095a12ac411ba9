// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/mapping/map_builder.h"
#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/session/known_map.h"
#include "revisit_slam/session/session_writer.h"
#include "revisit_slam/slam/session_targets.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// What of a session is kept on disk as it goes, and how it is written elsewhere on request. What
/// cannot be written waits (SessionWriter).
class SessionLog {
 public:
  /// The graph must outlive this.
  SessionLog(SessionId id, const SlamConfig& config, Stamp start, const SessionTarget& target,
             const SlamGraph& graph);

  /// A submap; the update's library keeps its occupancy and points from now on.
  void keep(const MapUpdatePtr& update);

  // In order, when the scans that they speak of are in the graph.

  /// Its submap has been closed.
  void add(const MapUpdatePtr& update);
  /// A local map that has been searched for loops.
  void add(StoredLocalMap map);
  /// The graph has been optimised up to a scan.
  void add(std::uint32_t version, ScanId last, std::vector<LoopConstraint> new_loops,
           std::optional<LoopId> disabled);
  void add(const BackEndConfig& changed);

  /// What could not be written is tried again about once a second; a folder that was removed is
  /// written anew, from what is in memory. To be called with every scan.
  void careForWriter();

  /// Writes what is known, and with `open_scans` also those that are in no closed submap yet.
  /// @throws std::runtime_error naming what cannot be written.
  void flush(bool open_scans);
  /// All of it in another, unused folder. @throws std::runtime_error naming what cannot be written.
  void copyTo(const std::string& folder);

  /// The session as it is now, for exports; its submaps are those in the folder.
  Session snapshot() const;

  const KnownMapPtr& prior() const { return target_.prior; }
  /// Empty: nothing is written unless asked for.
  const std::string& folder() const { return target_.folder; }
  const std::string& sensor() const { return target_.sensor; }
  bool isWritten() const { return writer_ != nullptr; }
  /// Why something waits to be written; empty: nothing does.
  std::string problem() const { return writer_ ? writer_->problem() : ""; }
  WriterBacklog backlog() const { return writer_ ? writer_->backlog() : WriterBacklog{}; }
  /// Whether every scan is in a submap that is closed.
  bool isWhole() const { return logged_scans_ == graph_.size(); }

  /// By number; without points.
  const std::vector<SubmapPtr>& submaps() const { return submaps_; }
  /// With points. @throws std::runtime_error where they cannot be read.
  SubmapPtr whole(const Submap& submap) const { return library_->whole(submap.id); }
  std::size_t pointsOf(const Submap& submap) const { return library_->points(submap.id); }
  /// Null where occupancy is switched off, or cannot be read.
  SubmapOccupancyPtr occupancy(const Submap& submap) const;

 private:
  GraphOptimised optimised(std::vector<LoopConstraint> new_loops) const;
  TrajectoryWritten optimisedTrajectory() const;
  void writeGeoreference(SessionWriter& writer) const;
  void addTrajectory();
  std::vector<GraphNode> nodesFrom(std::size_t first, std::size_t end) const;
  void writeAll(SessionWriter& writer, const SessionWriter* lost) const;
  std::size_t loopsBefore() const;
  /// `reads_copies`: of the prior's submaps, from then on.
  void writePrior(SessionWriter& writer, bool reads_copies) const;
  MapUpdatePtr stored(std::size_t submap, const SessionWriter* lost) const;

  const SlamGraph& graph_;
  const int niceness_;
  SessionTarget target_;
  SessionInfo info_;
  const std::size_t scans_before_;           // of sessions that were mapped before
  std::vector<SubmapClosed> closed_before_;  // by these

  std::shared_ptr<SubmapLibrary> library_ = std::make_shared<SubmapLibrary>(0);
  std::vector<SubmapPtr> submaps_;    // by number
  std::vector<SubmapClosed> closed_;  // those of submaps_ whose scans are all there
  std::size_t logged_scans_;          // of the graph that are written
  std::vector<StoredLocalMap> local_maps_;

  std::uint32_t version_ = 0;             // of the last optimisation
  ScanId last_corrected_;                 // by it
  std::uint32_t trajectory_version_ = 0;  // of what was logged

  std::unique_ptr<SessionWriter> writer_;  // null: nothing is written
};

}  // namespace revisit_slam
