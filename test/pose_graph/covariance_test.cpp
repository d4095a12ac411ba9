// SPDX-License-Identifier: MIT
#include <ceres/covariance.h>
#include <ceres/problem.h>
#include <gtest/gtest.h>

#include "pose_graph/graph_fixtures.h"
#include "revisit_slam/pose_graph/chain_piece.h"
#include "revisit_slam/pose_graph/relative_pose_cost.h"

namespace revisit_slam {
namespace {

using RowMajor6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

/// Covariance of the last node of a chain that starts at a fixed node, in its own frame.
Matrix6 covarianceOfEnd(const std::vector<Constraint>& chain) {
  ceres::Problem problem;
  std::vector<PoseBlock> blocks{blockOf({})};
  for (const Constraint& constraint : chain)
    blocks.push_back(blockOf(poseOf(blocks.back().data()) * constraint.T_from_to));
  for (PoseBlock& block : blocks) {
    problem.AddParameterBlock(block.data(), PoseChart::kAmbient);
    setManifold(problem, block.data(), new PoseManifold);
  }
  for (std::size_t i = 0; i < chain.size(); ++i)
    problem.AddResidualBlock(new RelativePoseCost(chain[i]), nullptr, blocks[i].data(),
                             blocks[i + 1].data());
  problem.SetParameterBlockConstant(blocks[0].data());
  ceres::Covariance covariance{ceres::Covariance::Options()};
  const double* end = blocks.back().data();
  EXPECT_TRUE(covariance.Compute(std::vector<std::pair<const double*, const double*>>{{end, end}},
                                 &problem));
  RowMajor6 result;
  EXPECT_TRUE(covariance.GetCovarianceBlockInTangentSpace(end, end, result.data()));
  return result;
}

TEST(Covariance, OfOneConstraintIsTheInputWithItsCorrelations) {
  RandomNumbers random(1);
  const Matrix6 expected = correlatedCovariance(sigmas(0.1, 0.02));
  const Constraint constraint{ScanId{0}, ScanId{1}, random.pose(5.0), expected.inverse()};
  EXPECT_LT((covarianceOfEnd({constraint}) - expected).norm(), 1e-8 * expected.norm());
}

TEST(Covariance, AlongAChainIsThatOfTheComposedConstraint) {
  RandomNumbers random(2);
  std::vector<Constraint> chain;
  for (std::uint32_t i = 0; i < 4; ++i)
    chain.push_back({ScanId{i}, ScanId{i + 1}, random.pose(3.0), correlatedInformation(0.1, 0.02)});
  ChainPiece piece;
  for (const Constraint& constraint : chain) piece.push_back(&constraint);
  const Matrix6 expected = composed(piece).information.inverse();
  EXPECT_LT((covarianceOfEnd(chain) - expected).norm(), 1e-8 * expected.norm());
}

}  // namespace
}  // namespace revisit_slam
