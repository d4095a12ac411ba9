// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "revisit_slam/types/informed_scan.h"
#include "revisit_slam/util/stage_times.h"

namespace revisit_slam {

/// Scan i is at x = 2 i and took i + 1 ms to register.
inline InformedScan scanAt(std::uint32_t i) {
  auto scan = std::make_shared<RegisteredScan>();
  scan->id = {i};
  scan->stamp = {1'700'000'000'000'000'001 + i * 100'000'000LL};
  scan->T_odom_base.translation = {5.0 + 2.0 * i, 0, 0};
  InformedScan informed;
  informed.scan = scan;
  return informed;
}

inline StageTimes timesOf(std::uint32_t i) {
  return {{"register", i + 1.0}, {"downsample", 0.5}};
}

}  // namespace revisit_slam
