// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/map_status.h"

#include <string>

#include "revisit_slam/ros/messages/scan_messages.h"
#include "revisit_slam/util/process_usage.h"

namespace revisit_slam {

void MapStatus::add(const LoopSearchResult& search) {
  const std::size_t accepted = search.accepted().size();
  loops_ += static_cast<int>(accepted);
  rejected_loops_ += static_cast<int>(search.proposals.size() - accepted);
}

void MapStatus::tell(const MapManagerCount& count, std::size_t waiting, bool is_enabled,
                     diagnostic_msgs::DiagnosticStatus& status) {
  constexpr int most_waiting = 2;
  const int missed = count.missed_scans, thinned = count.thinned_scans;
  const int maps_waiting = count.maps_waiting;
  const bool is_behind = maps_waiting > most_waiting || thinned > told_thinned_;
  status.level = is_behind || missed > told_missed_ ? status.WARN : status.OK;
  status.message = is_behind ? "falling behind: loops are found late, and points of scans "
                               "may be left out; give the search more threads "
                               "(background/threads)"
                   : missed > told_missed_ ? "scans were missed; call odometry/reset"
                   : is_enabled            ? "running"
                                           : "switched off";
  told_missed_ = missed;
  told_thinned_ = thinned;
  addValue("scans waiting", std::to_string(waiting), status);
  addValue("scans missed", std::to_string(missed), status);
  addValue("scans without their points", std::to_string(thinned), status);
  addValue("submaps", std::to_string(submaps_), status);
  addValue("local maps waiting", std::to_string(maps_waiting), status);
  addValue("loops accepted", std::to_string(loops_), status);
  addValue("loops rejected", std::to_string(rejected_loops_), status);
  addValue("memory (MB)", std::to_string(memoryMegabytes()), status);
}

}  // namespace revisit_slam
