// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/thinned_scan.h"

#include <memory>

namespace revisit_slam {

RegisteredScanPtr withoutPoints(const RegisteredScan& scan) {
  auto thinned = std::make_shared<RegisteredScan>();
  thinned->id = scan.id;
  thinned->stamp = scan.stamp;
  thinned->T_odom_base = scan.T_odom_base;
  thinned->sensor_base = scan.sensor_base;
  thinned->voxel_size = scan.voxel_size;
  thinned->verdict = scan.verdict;
  thinned->goes_on_from = scan.goes_on_from;
  return thinned;
}

}  // namespace revisit_slam
