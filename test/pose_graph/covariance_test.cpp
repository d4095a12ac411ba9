// SPDX-License-Identifier: MIT
#include <ceres/covariance.h>
#include <ceres/problem.h>
#include <gtest/gtest.h>

#include "pose_graph/graph_fixtures.h"
#include "revisit_slam/pose_graph/chain_piece.h"
#include "revisit_slam/pose_graph/factor_cost.h"
#include "revisit_slam/pose_graph/pose_block.h"

namespace revisit_slam {
namespace {

using RowMajor6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

/// Covariance of the last node of a chain that starts at a fixed node, in its own frame.
Matrix6 covarianceOfEnd(const std::vector<RelativePoseFactor>& chain) {
  ceres::Problem problem;
  std::vector<PoseBlock> blocks{blockOf({})};
  for (const RelativePoseFactor& link : chain)
    blocks.push_back(blockOf(poseOf(blocks.back().data()) * link.T_from_to));
  for (PoseBlock& block : blocks) {
    problem.AddParameterBlock(block.data(), PoseChart::kAmbient);
    setManifold(problem, block.data(), new PoseManifold);
  }
  std::vector<Factor> factors;
  for (const RelativePoseFactor& link : chain) factors.push_back({link, {}});
  for (std::size_t i = 0; i < factors.size(); ++i)
    problem.AddResidualBlock(makeCost(factors[i]).release(), nullptr, blocks[i].data(),
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

TEST(Covariance, OfOneFactorIsTheInputWithItsCorrelations) {
  RandomNumbers random(1);
  const Matrix6 expected = correlatedCovariance(sigmas(0.1, 0.02));
  const RelativePoseFactor link{{NodeId{0}, NodeId{1}}, random.pose(5.0), expected.inverse()};
  EXPECT_LT((covarianceOfEnd({link}) - expected).norm(), 1e-8 * expected.norm());
}

TEST(Covariance, AlongAChainIsThatOfTheComposedFactor) {
  RandomNumbers random(2);
  std::vector<RelativePoseFactor> chain;
  for (std::uint32_t i = 0; i < 4; ++i)
    chain.push_back(
        {{NodeId{i}, NodeId{i + 1}}, random.pose(3.0), correlatedInformation(0.1, 0.02)});
  ChainPiece piece;
  for (const RelativePoseFactor& link : chain) piece.push_back(&link);
  const Matrix6 expected = composed(piece).information.inverse();
  EXPECT_LT((covarianceOfEnd(chain) - expected).norm(), 1e-8 * expected.norm());
}

}  // namespace
}  // namespace revisit_slam
