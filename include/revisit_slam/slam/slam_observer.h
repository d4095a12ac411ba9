// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/loops/search/loop_search_result.h"
#include "revisit_slam/mapping/map_builder.h"
#include "revisit_slam/slam/graph_session.h"
#include "revisit_slam/types/informed_scan.h"
#include "revisit_slam/types/map_correction.h"
#include "revisit_slam/util/stage_times.h"

namespace revisit_slam {

/// Receives what the stages come up with, in the thread where it comes up.
class SlamObserver {
 public:
  virtual ~SlamObserver() = default;

  // In the thread that inserts scans.
  virtual void onScan(const InformedScan&, const StageTimes&) {}
  virtual void onRejection(const std::string& /*reason*/) {}
  /// Of a session that began by itself, or of messages that are no usual sweeps.
  virtual void onNotice(const std::string&) {}
  virtual void onMaps(const MapUpdate&) {}
  // In the background.
  virtual void onLoopSearch(const LoopSearchResult&) {}
  virtual void onCorrection(const MapCorrectionPtr&) {}
  /// A session has ended: all its maps are closed and searched.
  virtual void onSession(GraphSession&) {}
};

}  // namespace revisit_slam
