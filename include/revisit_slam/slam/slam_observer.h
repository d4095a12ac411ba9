// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/map_correction.h"
#include "revisit_slam/loops/search/loop_search.h"
#include "revisit_slam/slam/map_builder.h"

namespace revisit_slam {

/// Hears of what the stages behind the odometry come up with, in the thread where it comes up.
class SlamObserver {
 public:
  virtual ~SlamObserver() = default;

  /// In the thread that inserts scans.
  virtual void onMaps(const MapUpdate&) {}
  /// The next two in the background thread.
  virtual void onLoopSearch(const LoopSearchResult&) {}
  virtual void onCorrection(const MapCorrectionPtr&) {}
};

}  // namespace revisit_slam
