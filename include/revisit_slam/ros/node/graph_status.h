// SPDX-License-Identifier: MIT
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "revisit_slam/slam/graph_session.h"

namespace revisit_slam {

/// How the graph is, as its worker last said: told in another thread without waiting for it.
class GraphStatus {
 public:
  void note(const GraphSession& session);
  /// Scans of no use, as scans before them were missed.
  void noteMissedScan();
  void noteCorrection(const MapCorrection& correction);

  /// `waiting`: work that has not been done. Rejections are told once.
  void tell(std::size_t waiting, diagnostic_msgs::DiagnosticStatus& status);

 private:
  std::mutex mutex_;                  // guards what follows
  std::map<std::string, int> loops_;  // by origin and state
  std::size_t scans_ = 0, submaps_ = 0;
  OptimisationCount count_;
  int told_rejections_ = 0, missed_scans_ = 0, told_misses_ = 0;
  std::uint32_t version_ = 0;
  double moved_end_ = 0.0;  // m
  std::optional<Georeference> georeference_;
  std::string folder_, problem_;
  WriterBacklog backlog_;
};

}  // namespace revisit_slam
