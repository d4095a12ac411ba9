// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "revisit_slam/pose_graph/chain_piece.h"
#include "revisit_slam/pose_graph/solver.h"
#include "support/random_numbers.h"

namespace revisit_slam {

/// A correlated, anisotropic covariance with standard deviations near `sigma`.
inline Matrix6 correlatedCovariance(const Tangent& sigma) {
  RandomNumbers random(99);
  Matrix6 mixing = Matrix6::Identity();
  for (int i = 0; i < 36; ++i) mixing(i / 6, i % 6) += random.uniform(-0.6, 0.6);
  const Matrix6 root = sigma.asDiagonal() * mixing;
  return root * root.transpose();
}

inline Tangent sigmas(double translation, double rotation) {
  Tangent sigma;
  sigma << translation, 0.3 * translation, 2.0 * translation, rotation, 3.0 * rotation,
      0.5 * rotation;
  return sigma;
}

inline Matrix6 correlatedInformation(double translation = 0.02, double rotation = 0.001) {
  return correlatedCovariance(sigmas(translation, rotation)).inverse();
}

/// A drive in laps with its truth and a pose graph that starts at dead reckoning.
struct LapDrive {
  std::vector<Pose> truth;
  PoseGraph graph;
  std::vector<RelativePoseFactor> loops;  ///< the last factors of the graph
};

inline std::vector<Pose> lapTruth(int nodes, int per_lap) {
  std::vector<Pose> truth;
  for (int i = 0; i < nodes; ++i) {
    const double turn = 2.0 * M_PI * i / per_lap, radius = per_lap / (2.0 * M_PI);
    const Eigen::Vector3d rotation(0.02 * std::sin(3.0 * turn), 0.01 * std::cos(turn), 0.0);
    const Pose heading{expSO3({0.0, 0.0, turn}), Eigen::Vector3d::Zero()};
    const Pose tilt{expSO3(rotation), {radius, 0.0, std::sin(2.0 * turn)}};
    truth.push_back(heading * tilt);
  }
  return truth;
}

/// Z = T_i_j Exp(n) with n drawn by the covariance.
inline RelativePoseFactor measured(const std::vector<Pose>& truth, std::uint32_t from,
                                   std::uint32_t to, const Matrix6& covariance,
                                   RandomNumbers& random) {
  Tangent unit;
  for (int i = 0; i < 6; ++i) unit[i] = random.gaussian(1.0);
  const Tangent noise = covariance.llt().matrixL() * unit;
  const Pose T_from_to = boxplus(truth[from].inverse() * truth[to], noise);
  return {{NodeId{from}, NodeId{to}}, T_from_to, covariance.inverse()};
}

/// A metre between nodes, a loop from every `loop_every`-th node of the later laps to the lap
/// before.
inline LapDrive lapDrive(int nodes, int per_lap, int loop_every, const RobustKernel& kernel = {}) {
  RandomNumbers random(5);
  LapDrive drive{lapTruth(nodes, per_lap), {}, {}};
  const Matrix6 odometry = correlatedCovariance(sigmas(0.01, 0.0003));
  const Matrix6 loop = correlatedCovariance(sigmas(0.03, 0.002));
  Pose T_map_node = drive.truth[0];
  drive.graph.addNode(T_map_node);
  for (std::uint32_t i = 1; i < drive.truth.size(); ++i) {
    const RelativePoseFactor step = measured(drive.truth, i - 1, i, odometry, random);
    T_map_node = T_map_node * step.T_from_to;
    drive.graph.addNode(T_map_node);
    drive.graph.addFactor(step);
  }
  for (int i = per_lap; i < nodes; i += loop_every)
    drive.loops.push_back(measured(drive.truth, static_cast<std::uint32_t>(i - per_lap),
                                   static_cast<std::uint32_t>(i), loop, random));
  for (const RelativePoseFactor& closed : drive.loops) drive.graph.addFactor(closed, kernel);
  return drive;
}

/// A position for every `every`-th node, a lever of 2 m above it, with errors of 5 cm.
inline std::vector<PositionFactor> positionsOf(const std::vector<Pose>& truth,
                                               std::uint32_t every) {
  RandomNumbers random(6);
  std::vector<PositionFactor> positions;
  for (std::uint32_t i = every / 2; i < truth.size(); i += every) {
    PositionFactor position{{NodeId{i}}, {0.5, 0.0, 2.0}};
    position.p_map = truth[i] * position.p_node;
    position.information *= 400.0;
    for (int axis = 0; axis < 3; ++axis) position.p_map[axis] += random.gaussian(0.05);
    positions.push_back(position);
  }
  return positions;
}

/// Root mean square distance.
inline double positionError(const std::vector<Pose>& poses, const std::vector<Pose>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    sum += (poses[i].translation - truth[i].translation).squaredNorm();
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

inline RobustKernel kernelOf(const std::string& name, double scale = 5.0) {
  return {kernelTypeOf(name), scale};
}

/// Ends near the minimum.
inline SolverConfig exactConfig() {
  SolverConfig config;
  config.function_tolerance = 1e-10;
  return config;
}

}  // namespace revisit_slam
