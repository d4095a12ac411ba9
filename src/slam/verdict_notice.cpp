// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/verdict_notice.h"

#include <cstdio>

namespace revisit_slam {

std::string VerdictNotice::take(const InformedScan& informed) {
  const PoseVerdict before = last_;
  last_ = informed.verdict;
  if (informed.verdict == PoseVerdict::lost)
    return "the scan does not fit the map: the pose is lost, a new voxel map begins";
  if (informed.verdict == before) return "";
  if (informed.verdict == PoseVerdict::poor) {
    char text[160];
    std::snprintf(text, sizeof(text),
                  "the pose is poor: the map explains %.0f %% of the scan, and the pose is %.1f "
                  "standard deviations from the prediction",
                  100.0 * informed.scan->registration.explained, informed.scan->jump);
    return text;
  }
  return before >= PoseVerdict::poor ? "the scans fit the map again" : "";
}

}  // namespace revisit_slam
