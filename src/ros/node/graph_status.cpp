// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/graph_status.h"

#include <cmath>

#include "revisit_slam/ros/messages/scan_messages.h"
#include "revisit_slam/util/process_usage.h"

namespace revisit_slam {

void GraphStatus::note(const GraphSession& session) {
  const std::lock_guard<std::mutex> lock(mutex_);
  loops_.clear();
  for (const LoopEdge& edge : session.graph().loops())
    ++loops_[std::string(toString(edge.loop.origin)) + ", " + toString(edge.state)];
  scans_ = session.graph().size();
  submaps_ = session.submaps().size();
  count_ = session.count();
  folder_ = session.folder();
  problem_ = session.problem();
  backlog_ = session.backlog();
  if (count_.optimisations > 0) return;  // else a session that has just begun
  version_ = 0;
  told_rejections_ = 0;
}

void GraphStatus::noteMissedScan() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++missed_scans_;
}

void GraphStatus::noteCorrection(const MapCorrection& correction) {
  const std::lock_guard<std::mutex> lock(mutex_);
  version_ = correction.version;
  moved_end_ = correction.moved_end;
  georeference_ = correction.georeference;
}

void GraphStatus::tell(std::size_t waiting, diagnostic_msgs::DiagnosticStatus& status) {
  constexpr std::size_t most_waiting = 200;  // 20 s of scans
  constexpr double slow_disk = 5.0;          // s
  const std::lock_guard<std::mutex> lock(mutex_);
  status.level = status.OK;
  status.message = "running";
  if (count_.rejected > told_rejections_) {
    status.level = status.WARN;
    status.message = "an optimisation was rejected";
  }
  if (missed_scans_ > told_misses_) {
    status.level = status.WARN;
    status.message = "scans were missed; call odometry/reset";
  }
  if (waiting > most_waiting) {
    status.level = status.WARN;
    status.message = "falling behind, " + std::to_string(waiting) +
                     " tasks wait: nothing is lost, but corrections come late; give the graph more "
                     "threads (backend/threads)";
  }
  if (backlog_.seconds > slow_disk) {
    status.level = status.WARN;
    status.message = "the disk is slow, " + std::to_string(backlog_.writes) +
                     " writes wait, the oldest for " +
                     std::to_string(std::lround(backlog_.seconds)) +
                     " s: nothing is lost, but they are in memory; put the folder on another disk";
  }
  if (!problem_.empty()) {
    status.level = status.ERROR;
    status.message = "the map is not on disk, and is tried again: " + problem_;
  }
  told_rejections_ = count_.rejected;
  told_misses_ = missed_scans_;
  addValue("scans", std::to_string(scans_), status);
  addValue("scans missed", std::to_string(missed_scans_), status);
  addValue("submaps", std::to_string(submaps_), status);
  for (const auto& [kind, count] : loops_)
    addValue("loops by " + kind, std::to_string(count), status);
  addValue("optimisations", std::to_string(count_.optimisations), status);
  addValue("optimisations rejected", std::to_string(count_.rejected), status);
  addValue("map version", std::to_string(version_), status);
  addValue("last correction moved the end by (m)", std::to_string(moved_end_), status);
  if (georeference_) {
    addValue("positions of GNSS", std::to_string(georeference_->fixes), status);
    addValue("positions of GNSS, outliers", std::to_string(georeference_->outliers), status);
    addValue("yaw of the map, standard deviation (rad)",
             std::to_string(georeference_->yaw_deviation), status);
  }
  addValue("waiting", std::to_string(waiting), status);
  addValue("waiting for the disk", std::to_string(backlog_.writes), status);
  addValue("memory (MB)", std::to_string(memoryMegabytes()), status);
  addValue("folder", folder_, status);
}

}  // namespace revisit_slam
