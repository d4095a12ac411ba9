// SPDX-License-Identifier: MIT
#include "revisit_slam/session/graph_files.h"

#include <cstdio>
#include <numeric>
#include <sstream>

#include "revisit_slam/io/g2o.h"
#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {

Trajectory trajectoryOf(const SlamGraph& graph) {
  Trajectory trajectory;
  trajectory.reserve(graph.size());
  for (const GraphNode& node : graph.nodes())
    trajectory.push_back({node.stamp, graph.pose(node.id)});
  return trajectory;
}

void writeGraph(const std::string& path, const SlamGraph& graph) {
  G2oGraph file{graph.graph(), std::vector<std::uint64_t>(graph.size())};
  std::iota(file.ids.begin(), file.ids.end(), 0);
  writeG2o(path, file);
}

void writeLoops(const std::string& path, const SlamGraph& graph) {
  std::ostringstream table;
  table << "loop,state,origin,target_map,source_map,target_submap,source_submap,target_scan,"
           "source_scan,target_stamp,source_stamp,x,y,z,qx,qy,qz,qw,fitness,inliers,"
           "residual_before,residual_after,weight\n";
  for (const LoopEdge& edge : graph.loops()) {
    const LoopConstraint& loop = edge.loop;
    const auto& [from, to, T, information] = loop.constraint;
    char numbers[512];
    std::snprintf(numbers, sizeof(numbers),
                  "%.6f,%.6f,%.6f,%.9f,%.9f,%.9f,%.9f,%.4f,%d,%.6g,%.6g,%.4f", T.translation.x(),
                  T.translation.y(), T.translation.z(), T.rotation.x(), T.rotation.y(),
                  T.rotation.z(), T.rotation.w(), loop.fitness, loop.inliers, edge.chi2_before,
                  edge.chi2_after, edge.weight);
    table << edge.id.value << "," << toString(edge.state) << "," << toString(loop.origin) << ","
          << loop.target_map.value << "," << loop.source_map.value << "," << loop.target.value
          << "," << loop.source.value << "," << from.value << "," << to.value << ","
          << stampText(graph.node(from).stamp) << "," << stampText(graph.node(to).stamp) << ","
          << numbers << "\n";
  }
  writeWholeText(path, table.str());
}

}  // namespace revisit_slam
