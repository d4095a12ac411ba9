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
    char share[32];
    std::snprintf(share, sizeof(share), "%.0f %%", 100.0 * informed.scan->registration.explained);
    return "the pose is poor: the map explains " + std::string(share) + " of the scan";
  }
  return before >= PoseVerdict::poor ? "the scans fit the map again" : "";
}

}  // namespace revisit_slam
