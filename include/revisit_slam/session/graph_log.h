// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "revisit_slam/pose_graph/graph_node.h"
#include "revisit_slam/types/map_correction.h"
#include "revisit_slam/types/submap.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// What graph.log and optimisations.log say (docs/session_format.md). Each is the same bytes for
/// the same drive, however long loops were searched for while it went on.

/// A submap has been closed, and its file is whole.
struct SubmapClosed {
  SubmapId id;
  LocalMapId local_map;
  ScanId first_scan, last_scan;
  Stamp stamp;                     ///< of the first scan
  Eigen::AlignedBox3f box_submap;  ///< of the detail points; empty where there are none
};
SubmapClosed closedOf(const Submap& submap, const Points& detail_submap);

/// Nodes of the graph, each with the odometry edge that leads to it; they follow those before.
struct ScansAdded {
  std::vector<GraphNode> nodes;
};

/// An optimisation: what it was given, and what came out of it.
struct GraphOptimised {
  std::uint32_t version = 0;                ///< MapCorrection::version
  ScanId last_scan;                         ///< up to here the graph was optimised
  std::optional<LoopId> disabled;           ///< left out before, on request
  std::vector<LoopConstraint> constraints;  ///< that were new
  Pose T_map_odom;                          ///< places all scans after last_scan
  std::vector<Pose> T_map_keypose;          ///< of the submaps up to last_scan, in their order
  /// Of all loops so far, by LoopId: state and residuals alone.
  struct Decision {
    LoopState state;
    double chi2_before, chi2_after, weight;
  };
  std::vector<Decision> decisions;
};

GraphOptimised::Decision decisionOf(const LoopEdge& edge);
void decide(const GraphOptimised::Decision& decision, LoopEdge& edge);

/// T_map_scan of all optimised scans, in their order, as the optimisation of this version left
/// them.
struct TrajectoryWritten {
  std::uint32_t version = 0;
  std::vector<Pose> T_map_scan;
};

/// Parameters that have changed during the drive.
struct ParametersChanged {
  std::vector<NamedText> values;
};

/// What was known of sessions that had been mapped before: of all scans before this session's.
struct SessionsTakenOver {
  std::vector<LoopEdge> loops;   ///< by LoopId
  std::vector<Pose> T_map_scan;  ///< session after session, by number
};

/// Positions of GNSS, of the scans that are added next: each with that with which it came.
struct FixesAdded {
  std::vector<std::pair<ScanId, GnssFix>> fixes;
};

/// Directions of gravity, likewise.
struct DirectionsAdded {
  std::vector<std::pair<ScanId, GravityDirection>> directions;
};

/// Where an optimisation left the map on the earth.
struct MapGeoreferenced {
  std::uint32_t version = 0;  ///< of the optimisation
  Georeference georeference;
};

using LogEntry =
    std::variant<SubmapClosed, ScansAdded, GraphOptimised, TrajectoryWritten, ParametersChanged,
                 SessionsTakenOver, FixesAdded, MapGeoreferenced, DirectionsAdded>;

/// Whether an entry is one of graph.log, which follows the drive; else it is one of
/// optimisations.log, which follows the graph.
bool belongsToDrive(const LogEntry& entry);

/// What either log begins with.
std::string graphLogHeader();
/// An entry as bytes of the log; scans with positions of GNSS or directions of
/// gravity as several.
std::string encodeEntry(const LogEntry& entry);

struct GraphLog {
  std::vector<LogEntry> entries;
  std::string damage;  ///< empty, or what of the file's end is left out, and why
};

/// @throws std::runtime_error naming a file that cannot be read.
GraphLog readGraphLog(const std::string& path);

}  // namespace revisit_slam
