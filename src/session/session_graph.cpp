// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_graph.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <sstream>

#include "revisit_slam/io/g2o.h"
#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {

namespace {

/// Nodes and factors as the optimiser has them.
PoseGraph poseGraphOf(const SessionGraph& session) {
  const auto is_active = [](const LoopEdge& edge) { return edge.state == LoopState::active; };
  const bool has_loops = std::any_of(session.loops.begin(), session.loops.end(), is_active);
  const SessionOffsets<ScanId> scans = scansOf(session);
  const auto nodeOf = [&](ScanId scan) { return NodeId{static_cast<std::uint32_t>(scans[scan])}; };
  PoseGraph graph;
  const auto relate = [&](const Constraint& constraint) {
    graph.addFactor(RelativePoseFactor{{nodeOf(constraint.from), nodeOf(constraint.to)},
                                       constraint.T_from_to,
                                       constraint.information});
  };
  const std::vector<GraphNode>& nodes = session.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    graph.addNode(has_loops ? session.T_map_scan[i] : nodes[i].T_odom_base);
    if (i == 0 || nodes[i].id.session != nodes[i - 1].id.session) continue;
    relate({nodes[i - 1].id, nodes[i].id, nodes[i - 1].T_odom_base.inverse() * nodes[i].T_odom_base,
            nodes[i].information});
  }
  for (const LoopEdge& edge : session.loops)
    if (is_active(edge)) relate(edge.loop.constraint);
  return graph;
}

}  // namespace

SessionOffsets<ScanId> scansOf(const SessionGraph& graph) {
  SessionOffsets<ScanId> scans;
  for (const GraphNode& node : graph.nodes) scans.append(node.id);
  return scans;
}

SessionGraph graphOf(const SlamGraph& graph) {
  return {graph.nodes(), graph.poses(), graph.T_map_odom(), graph.loops(), graph.georeference()};
}

Trajectory trajectoryOf(const SessionGraph& graph) {
  Trajectory trajectory;
  trajectory.reserve(graph.nodes.size());
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    trajectory.push_back({graph.nodes[i].stamp, graph.T_map_scan[i]});
  return trajectory;
}

void writeGraph(const std::string& path, const SessionGraph& graph) {
  G2oGraph file{poseGraphOf(graph), std::vector<std::uint64_t>(graph.nodes.size())};
  std::iota(file.ids.begin(), file.ids.end(), 0);
  writeG2o(path, file);
}

void writeLoops(const std::string& path, const SessionGraph& graph) {
  const SessionOffsets<ScanId> scans = scansOf(graph);
  std::ostringstream table;
  table << "loop,state,origin,target_map,source_map,target_submap,source_submap,target_scan,"
           "source_scan,target_stamp,source_stamp,x,y,z,qx,qy,qz,qw,fitness,inliers,"
           "residual_before,residual_after,weight,target_session,source_session\n";
  for (const LoopEdge& edge : graph.loops) {
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
          << stampText(graph.nodes[scans[from]].stamp) << ","
          << stampText(graph.nodes[scans[to]].stamp) << "," << numbers << ","
          << loop.target.session.value << "," << loop.source.session.value << "\n";
  }
  writeWholeText(path, table.str());
}

}  // namespace revisit_slam
