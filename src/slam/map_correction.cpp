// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/map_correction.h"

namespace revisit_slam {

MapCorrection correctionOf(const SlamGraph& graph, ScanId last) {
  MapCorrection correction;
  correction.session = last.session;
  for (const GraphNode& node : graph.nodes()) {
    correction.T_map_scan.push_back(graph.pose(node.id));
    if (node.id == last) break;
  }
  correction.T_map_odom = graph.T_map_odom();
  correction.loops = graph.loops();
  correction.georeference = graph.georeference();
  correction.moved_end = graph.movedEnd();
  correction.seconds = graph.lastSolution().seconds;
  return correction;
}

}  // namespace revisit_slam
