// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/gravity_factors.h"

#include <algorithm>
#include <map>

namespace revisit_slam {
namespace {

/// A node starts where another is, and stays there but for its tilt, which deviates.
NodeId addTilted(PoseGraph& graph, NodeId other, const Eigen::Quaterniond& R_other_node,
                 double deviation) {
  const Pose T_map_other = graph.poses()[other.value];
  const NodeId node = graph.addNode(T_map_other * Pose{R_other_node, Eigen::Vector3d::Zero()});
  RelativePoseFactor held{
      {other, node}, Pose{R_other_node, Eigen::Vector3d::Zero()}, Matrix6::Identity()};
  held.information.diagonal().segment<2>(3).setConstant(1.0 / (deviation * deviation));
  graph.addFactor(held);
  return node;
}

constexpr double kAnyTilt = 3.0;  // rad

}  // namespace

void GravityFactors::add(std::size_t node, const GravityDirection& direction, std::size_t first) {
  if (!config_.enabled) return;
  const NodeId first_node{static_cast<std::uint32_t>(first)};
  const NodeId scan{first_node.value + direction.scan.value};
  if (scan != first_node) directions_.push_back({node, first_node, scan, direction.up_base});
}

std::size_t GravityFactors::countOf(std::size_t nodes) const {
  const auto end = std::partition_point(directions_.begin(), directions_.end(),
                                        [&](const Tied& tied) { return tied.node < nodes; });
  return static_cast<std::size_t>(end - directions_.begin());
}

void GravityFactors::addTo(PoseGraph& graph, std::optional<NodeId> level,
                           const IsInMap& is_in_map) const {
  const std::size_t count = countOf(graph.poses().size());
  const double information = 1.0 / (config_.deviation * config_.deviation);
  const RobustKernel kernel{KernelType::geman_mcclure, config_.kernel_scale};
  std::map<std::uint32_t, NodeId> imus;  // by the first node of their session
  for (std::size_t i = 0; i < count; ++i) {
    const Tied& tied = directions_[i];
    if (!is_in_map(tied.scan)) continue;
    if (!level) level = addLevel(graph, tied.first);
    const auto [imu, is_new] = imus.try_emplace(tied.first.value);
    if (is_new)
      imu->second = addTilted(graph, tied.first, Eigen::Quaterniond::Identity(), config_.bias);
    graph.addFactor(GravityFactor{{tied.first, imu->second, *level, tied.scan},
                                  tied.up,
                                  information * Eigen::Matrix3d::Identity()},
                    kernel);
  }
}

/// As the directions have it in the mean: the optimisation is linear enough from there.
NodeId GravityFactors::addLevel(PoseGraph& graph, NodeId first) const {
  Eigen::Vector3d up_map = Eigen::Vector3d::Zero();
  for (const Tied& tied : directions_)
    if (tied.node < graph.poses().size())
      up_map += graph.poses()[tied.scan.value].rotation * tied.up;
  const auto R_map_level = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), up_map);
  return addTilted(graph, first, graph.poses()[first.value].rotation.conjugate() * R_map_level,
                   kAnyTilt);
}

}  // namespace revisit_slam
