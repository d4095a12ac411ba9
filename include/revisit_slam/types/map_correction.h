// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "revisit_slam/types/georeference.h"
#include "revisit_slam/types/loop_edge.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/session_groups.h"

namespace revisit_slam {

/// What an optimisation made of the map: one numbered, immutable snapshot (paper Sec. III-D).
struct MapCorrection {
  SessionId session;
  /// Counts from 1. 0: nothing has changed, and this answers a request alone.
  std::uint32_t version = 0;
  /// The loop closures that it answers (LoopClosures::request); 0: it was asked for otherwise.
  std::uint32_t request = 0;
  /// Session after session, by ScanId, as far as the optimised graph went.
  std::vector<Pose> T_map_scan;
  /// Where the scans of each session begin among those.
  std::map<SessionId, std::size_t> begin;
  /// Places every scan after those: T_map_scan = T_map_odom * T_odom_scan.
  Pose T_map_odom;
  /// All loop constraints so far, by LoopId.
  std::vector<LoopEdge> loops;
  /// Where the map lies on the earth; none: not known yet.
  std::optional<Georeference> georeference;
  /// How far the end of the optimised trajectory moved, m.
  double moved_end = 0.0;
  double seconds = 0.0;  ///< of optimisation

  /// Whether loops tie a session to the first one, whose the map is.
  bool places(SessionId of_session) const {
    return begin.empty() || SessionGroups(loops).areTied(of_session, begin.begin()->first);
  }
};

using MapCorrectionPtr = std::shared_ptr<const MapCorrection>;

/// The answer to a request where there is nothing to correct, or no graph of the session.
inline MapCorrectionPtr unchangedMap(SessionId session, std::uint32_t request) {
  MapCorrection nothing;
  nothing.session = session;
  nothing.request = request;
  return std::make_shared<const MapCorrection>(std::move(nothing));
}

}  // namespace revisit_slam
