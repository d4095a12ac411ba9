// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "revisit_slam/pose_graph/pose_graph.h"

namespace revisit_slam {

/// A pose graph and the ids that its nodes have in the file.
struct G2oGraph {
  PoseGraph graph;
  std::vector<std::uint64_t> ids;  ///< by NodeId, ascending
};

/// Reads VERTEX_SE3:QUAT and EDGE_SE3:QUAT lines; the node with the smallest id comes first. Edges
/// from a node to the next are odometry and the first factors, all others loops with this kernel.
/// FIX lines hold nodes; comments and PARAMS_ lines are passed over. A graph has a node.
/// @throws std::runtime_error naming the file and the line that cannot be used.
G2oGraph readG2o(const std::string& path, const RobustKernel& loop_kernel = {});

/// Writes all digits, so that reading gives the same numbers. Relative poses alone are written; a
/// comment says how many factors of other kinds there were.
/// @throws std::runtime_error naming the file.
void writeG2o(const std::string& path, const G2oGraph& graph);

/// g2o weighs another residual than ours, e_g2o = [t; v] with t the translation and v = sin(a/2) n
/// the vector part of the unit quaternion (real part >= 0) of E = Z^-1 T_i^-1 T_j; a and n are
/// angle and axis. Ours is e = Log(E) = [V^-1(a n) t; a n]. To first order around E = I, v = a n /
/// 2 and V = I, hence
///
///   e_g2o = S e with S = diag(1, 1, 1, 1/2, 1/2, 1/2)  and  e^T (S L S) e = e_g2o^T L e_g2o:
///
/// the rotation block of a g2o information L counts a quarter and the cross blocks a half. Both
/// have the same tangent space, right perturbations of T_j in the order translation, rotation.
Matrix6 informationFromG2o(const Matrix6& information);
Matrix6 informationToG2o(const Matrix6& information);

/// The sum of e_g2o^T L e_g2o over all relative poses, as g2o prints it, without robust kernels.
double g2oChi2(const PoseGraph& graph, const std::vector<Pose>& poses);

}  // namespace revisit_slam
