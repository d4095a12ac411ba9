// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "revisit_slam/pose_graph/graph_ids.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// The types that go with a residual e of `rows` numbers on `nodes` poses.
template <int rows, std::size_t nodes>
struct FactorShape {
  static constexpr int kRows = rows;
  static constexpr std::size_t kNodes = nodes;

  using Nodes = std::array<NodeId, nodes>;
  using Poses = std::array<Pose, nodes>;  ///< T_map_node of these
  using Error = Eigen::Matrix<double, rows, 1>;
  using Information = Eigen::Matrix<double, rows, rows>;
  using Jacobian = Eigen::Matrix<double, rows, 6>;

  /// With U^T U = information, the residual U e and its derivatives U de/dd_k by the right
  /// perturbations T_k * Exp(d_k) of the poses.
  struct Linearization {
    Error residual;
    std::array<Jacobian, nodes> jacobians;
  };
};

}  // namespace revisit_slam
