// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/map_correction.h"

namespace revisit_slam {

MapCorrection correctionOf(const SlamGraph& graph, ScanId last) {
  MapCorrection correction;
  correction.session = last.session;
  for (const GraphNode& node : graph.nodes()) {
    correction.begin.emplace(node.id.session, correction.T_map_scan.size());
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

MapCorrection correctionOf(const std::vector<const KnownMap*>& maps) {
  MapCorrection known;
  for (const KnownMap* map : maps) {
    for (std::size_t i = 0; i < map->nodes.size(); ++i)
      known.begin.emplace(map->nodes[i].id.session, known.T_map_scan.size() + i);
    const std::vector<Pose>& T_map_scan = map->session.graph.T_map_scan;
    known.T_map_scan.insert(known.T_map_scan.end(), T_map_scan.begin(), T_map_scan.end());
    known.loops.insert(known.loops.end(), map->loops.begin(), map->loops.end());
    known.session = map->nodes.back().id.session;
  }
  return known;
}

}  // namespace revisit_slam
