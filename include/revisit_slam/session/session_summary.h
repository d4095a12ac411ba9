// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/session/session_reader.h"
#include "revisit_slam/session/stored_local_map.h"
#include "revisit_slam/types/loop_edge.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// A submap without its scans and points.
struct SummarisedSubmap {
  SubmapId id;
  LocalMapId local_map;
  ScanId first_scan;
  Stamp stamp;                                ///< of the first scan
  double travelled_begin = 0.0;               ///< as in Submap
  UnsureDistance unsure_begin;                ///< likewise
  Pose T_odom_submap;                         ///< the keypose as the odometry had it
  Pose T_map_submap;                          ///< as the session's own graph has it
  Matrix6 information = Matrix6::Identity();  ///< of the motion since the keypose before
};

/// What joining many sessions needs of one: its places, and its graph reduced to keyposes, to which
/// all loops are bound. About 0.3 MB for each kilometre, where the session has 50.
struct SessionSummary {
  std::string name;                       ///< tells it from other sessions
  Stamp start;                            ///< of the first scan
  double length = 0.0;                    ///< m, travelled distance at the last keypose
  std::vector<SummarisedSubmap> submaps;  ///< by number
  std::vector<LoopEdge> loops;            ///< of the session itself, between first scans of submaps
  std::vector<StoredLocalMap> places;     ///< by number
};

/// Of a folder with one session, up to its last closed submap. Places that cannot be read are named
/// in `notices`. @throws std::runtime_error naming the folder and why it cannot be used.
SessionSummary summarise(const std::string& folder, const std::string& name,
                         std::vector<std::string>& notices);

/// As bytes of a file, NAME.rss.
std::string encodeSummary(const SessionSummary& summary);
/// @throws std::runtime_error naming a file that cannot be read, or is damaged.
SessionSummary readSummary(const std::string& path);

}  // namespace revisit_slam
