// SPDX-License-Identifier: MIT
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <atomic>

#include "revisit_slam/slam/map_manager.h"

namespace revisit_slam {

/// How the maps are, told in another thread than those of the two lanes.
class MapStatus {
 public:
  void addSubmap() { ++submaps_; }
  void add(const LoopSearchResult& search);

  /// `waiting`: scans that are in no submap yet.
  void tell(const MapManagerCount& count, std::size_t waiting, bool is_enabled,
            diagnostic_msgs::DiagnosticStatus& status);

 private:
  std::atomic<int> submaps_{0}, loops_{0}, rejected_loops_{0};
  int told_missed_ = 0, told_thinned_ = 0;
};

}  // namespace revisit_slam
