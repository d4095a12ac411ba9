// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "revisit_slam/types/gnss_fix.h"
#include "revisit_slam/types/informed_scan.h"

namespace revisit_slam {

/// What the graph keeps of a scan: one node, and the odometry edge that leads to it.
struct GraphNode {
  ScanId id;
  Stamp stamp;
  Pose T_odom_base;
  Matrix6 information = Matrix6::Identity();  ///< Lambda_odo, of the motion since the scan before
  // Of it or of scans before, and take part from this scan on.
  std::vector<GnssFix> fixes{};
  std::optional<GravityDirection> gravity{};
};

inline GraphNode nodeOf(const InformedScan& informed) {
  const RegisteredScan& scan = *informed.scan;
  return {scan.id,    scan.stamp,  scan.T_odom_base, informed.estimate.information,
          scan.fixes, scan.gravity};
}

}  // namespace revisit_slam
