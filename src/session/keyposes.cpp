// SPDX-License-Identifier: MIT
#include "revisit_slam/session/keyposes.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "revisit_slam/io/stored_pose.h"
#include "revisit_slam/pose_graph/chain_piece.h"

namespace revisit_slam {
namespace {

constexpr char kHeader[] = "submap,qx,qy,qz,qw,x,y,z";

RelativePoseFactor linkTo(const std::vector<GraphNode>& nodes, std::size_t scan) {
  return {{NodeId{static_cast<std::uint32_t>(scan - 1)}, NodeId{static_cast<std::uint32_t>(scan)}},
          nodes[scan - 1].T_odom_base.inverse() * nodes[scan].T_odom_base,
          nodes[scan].information};
}

/// Of the scans between two others.
std::vector<Pose> posesBetween(const std::vector<GraphNode>& nodes, std::size_t first,
                               std::size_t last, const Pose& T_map_first, const Pose& T_map_last) {
  std::vector<RelativePoseFactor> links;
  for (std::size_t scan = first + 1; scan <= last; ++scan) links.push_back(linkTo(nodes, scan));
  ChainPiece piece;
  for (const RelativePoseFactor& link : links) piece.push_back(&link);
  return bentPiece(piece, T_map_first, T_map_last);
}

/// @throws std::invalid_argument for what is no pose of this number.
Pose poseOf(const std::string& line, std::size_t number) {
  std::istringstream fields(line);
  std::string field;
  std::getline(fields, field, ',');
  if (std::stoul(field) != number) throw std::invalid_argument("number of the submap");
  std::array<double, 7> values{};
  for (double& value : values) {
    if (!std::getline(fields, field, ',')) throw std::invalid_argument("seven numbers");
    value = std::stod(field);
  }
  const auto& [qx, qy, qz, qw, x, y, z] = values;
  Pose pose{Eigen::Quaterniond(qw, qx, qy, qz), {x, y, z}};
  if (!fields.eof() || !isPose(pose)) throw std::invalid_argument("pose");
  return pose;
}

}  // namespace

std::string keyposeText(const std::vector<Pose>& T_map_submap) {
  std::string text = std::string(kHeader) + "\n";
  for (std::size_t i = 0; i < T_map_submap.size(); ++i) {
    const Eigen::Quaterniond& q = T_map_submap[i].rotation;
    const Eigen::Vector3d& t = T_map_submap[i].translation;
    std::array<char, 256> line{};
    std::snprintf(line.data(), line.size(), "%zu,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", i,
                  q.x(), q.y(), q.z(), q.w(), t.x(), t.y(), t.z());
    text += line.data();
  }
  return text;
}

std::vector<Pose> readKeyposes(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != kHeader)
    throw std::runtime_error("'" + path + "' is no file of keyposes");
  std::vector<Pose> T_map_submap;
  while (std::getline(file, line)) {
    try {
      T_map_submap.push_back(poseOf(line, T_map_submap.size()));
    } catch (const std::logic_error&) {
      throw std::runtime_error("'" + path + "': line " + std::to_string(T_map_submap.size() + 2) +
                               " is no keypose");
    }
  }
  return T_map_submap;
}

void moveToKeyposes(const std::vector<Pose>& T_map_submap, Session& session) {
  if (sessionsOf(session).size() != 1 || T_map_submap.size() != session.submaps.size())
    throw std::runtime_error("the keyposes are those of another session than '" + session.folder +
                             "': " + std::to_string(T_map_submap.size()) + " of them, and " +
                             std::to_string(session.submaps.size()) + " submaps");
  SessionGraph& graph = session.graph;
  const SessionOffsets<ScanId> scans = scansOf(graph);
  std::vector<Pose> T_map_scan;
  for (std::size_t k = 0; k < T_map_submap.size(); ++k) {
    const std::size_t first = scans[session.submaps[k].first_scan];
    if (k > 0)
      for (const Pose& T : posesBetween(graph.nodes, T_map_scan.size() - 1, first,
                                        T_map_submap[k - 1], T_map_submap[k]))
        T_map_scan.push_back(T);
    T_map_scan.push_back(T_map_submap[k]);
    graph.T_map_odom = T_map_submap[k] * graph.nodes[first].T_odom_base.inverse();
  }
  while (T_map_scan.size() < graph.nodes.size())
    T_map_scan.push_back(graph.T_map_odom * graph.nodes[T_map_scan.size()].T_odom_base);
  if (!std::all_of(T_map_scan.begin(), T_map_scan.end(), isPose))
    throw std::runtime_error("the keyposes do not fit the drive in '" + session.folder + "'");
  if (graph.georeference && !T_map_scan.empty())  // of another map frame by now
    graph.georeference->T_enu_map =
        graph.georeference->T_enu_map * graph.T_map_scan.front() * T_map_scan.front().inverse();
  graph.T_map_scan = std::move(T_map_scan);
}

}  // namespace revisit_slam
