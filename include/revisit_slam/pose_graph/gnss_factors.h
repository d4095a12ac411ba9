// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "revisit_slam/geometry/local_enu.h"
#include "revisit_slam/pose_graph/pose_graph.h"
#include "revisit_slam/pose_graph/pose_graph_solution.h"
#include "revisit_slam/priors/gnss_config.h"
#include "revisit_slam/types/georeference.h"
#include "revisit_slam/types/gnss_fix.h"

namespace revisit_slam {

/// What stands for the positions of GNSS in a graph.
struct GnssTerms {
  NodeId enu;                   ///< the frame enu as a node: its pose is T_map_enu
  std::vector<FactorId> fixes;  ///< one for each position
  std::size_t looked_at = 0;    ///< positions, with those in other maps
  double yaw_deviation = 0.0;   ///< rad
};

/// The positions of GNSS of a drive, or of several sessions, as factors of its graph. The first
/// scan stays the gauge, so that the map neither turns nor jumps to where GNSS has it: the frame
/// enu is a node, which each position sees an antenna from, and moves against the map with each
/// optimisation.
class GnssFactors {
 public:
  /// @throws ParameterError for a datum that is none.
  explicit GnssFactors(const GnssConfig& config);

  /// Whether the pose of a node is in the map of the first one.
  using IsInMap = std::function<bool(NodeId)>;

  /// Positions that take part in graphs of more than `node` nodes. `first`: the node of the first
  /// scan of their session.
  void add(std::size_t node, const std::vector<GnssFix>& fixes, std::size_t first = 0);

  /// Of the frame enu, as long as no solution has used it: before a graph of so many nodes is
  /// solved, so that it does not depend on what comes after those.
  void placeOrigin(std::size_t nodes, const IsInMap& is_in_map);

  /// Whether a graph of so many nodes has positions that the last solution has not.
  bool hasNew(std::size_t nodes) const { return countOf(nodes) > used_; }

  /// Adds node and factors to a graph that has the nodes of all scans. Nothing where it has too few
  /// positions to align it. Those at scans in other maps do not count.
  std::optional<GnssTerms> addTo(PoseGraph& graph, const IsInMap& is_in_map) const;

  /// The solution of a graph with these terms.
  void take(const PoseGraphSolution& solution, const GnssTerms& terms, double min_inlier_weight);

  std::optional<Georeference> georeference() const { return georeference_; }
  /// Whether there may be positions: now, or of sessions that were mapped before.
  bool isConnected() const { return config_.isConnected() || !fixes_.empty(); }

 private:
  struct Tied {
    std::size_t node;  // with which it came
    NodeId scan;       // that it is tied to
    GnssFix fix;
    Eigen::Vector3d p_enu;
    Eigen::Matrix3d information;
  };

  std::vector<const Tied*> fixesOf(std::size_t nodes, const IsInMap& is_in_map) const;
  std::size_t countOf(std::size_t nodes) const;
  std::optional<Pose> bestStart(const PoseGraph& graph, const std::vector<const Tied*>& fixes,
                                double& deviation) const;
  RelativePositionFactor factorOf(const Tied& tied, NodeId enu) const;
  RobustKernel kernel() const { return {KernelType::geman_mcclure, config_.kernel_scale}; }

  GnssConfig config_;
  std::optional<GeodeticPosition> given_datum_;
  std::optional<LocalEnu> enu_;  // near the positions, whatever datum is given
  std::vector<Tied> fixes_;      // in the order of the nodes with which they came
  std::size_t used_ = 0;         // by the last solution, with those in other maps
  std::optional<Pose> T_map_enu_;
  std::optional<Georeference> georeference_;
};

}  // namespace revisit_slam
