// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/session_offsets.h"

namespace revisit_slam {

/// T_map_scan of the scans of one session, or of several. Sessions that loops do not tie to each
/// other (SessionGroups) have maps of their own.
class ScanPoses {
 public:
  /// Of one session, by number.
  ScanPoses(std::vector<Pose> T_map_scan) : T_map_scan_(std::move(T_map_scan)) {}
  /// Of several.
  ScanPoses(std::vector<Pose> T_map_scan, SessionOffsets<ScanId> scans)
      : T_map_scan_(std::move(T_map_scan)), scans_(std::move(scans)) {}

  const Pose& operator[](ScanId id) const { return T_map_scan_[indexOf(id)]; }
  /// From a scan on those of its session.
  std::vector<Pose> from(ScanId first, std::size_t count) const {
    const auto begin = T_map_scan_.begin() + static_cast<std::ptrdiff_t>(indexOf(first));
    return {begin, begin + static_cast<std::ptrdiff_t>(count)};
  }

 private:
  std::size_t indexOf(ScanId id) const { return scans_.size() > 0 ? scans_[id] : id.value; }

  std::vector<Pose> T_map_scan_;
  SessionOffsets<ScanId> scans_;  // empty: of one session
};

}  // namespace revisit_slam
