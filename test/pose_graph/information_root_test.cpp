// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/information_root.h"

#include <gtest/gtest.h>

#include "pose_graph/graph_fixtures.h"

namespace revisit_slam {
namespace {

double deviation(const Matrix6& information) {
  const Matrix6 U = informationRoot(information);
  return (U.transpose() * U - information).norm() / (1e-300 + information.norm());
}

TEST(InformationRoot, SquaresToTheInformation) {
  EXPECT_LT(deviation(correlatedInformation()), 1e-14);
  EXPECT_LT(deviation(1e-12 * correlatedInformation()), 1e-14);
  EXPECT_LT(deviation(1e12 * correlatedInformation()), 1e-14);
}

TEST(InformationRoot, OfSemiDefiniteInformationIsFinite) {
  const Matrix6 full = correlatedInformation(1.0, 1.0);
  const Matrix6 rank_two = full.leftCols<2>() * full.leftCols<2>().transpose();
  EXPECT_LT(deviation(rank_two), 1e-12);
  EXPECT_EQ(informationRoot<6>(Matrix6::Zero()).norm(), 0.0);
}

TEST(InformationRoot, TakesNegativeEigenvaluesAsZero) {
  Tangent eigenvalues;
  eigenvalues << 4.0, 1.0, 9.0, -1e-9, 0.0, 1.0;
  const Matrix6 U = informationRoot<6>(eigenvalues.asDiagonal());
  const Matrix6 expected = eigenvalues.cwiseMax(0.0).asDiagonal();
  EXPECT_LT((U.transpose() * U - expected).norm(), 1e-14);
}

TEST(InformationRoot, TakesTheSymmetricPart) {
  Matrix6 asymmetric = Matrix6::Identity();
  asymmetric(0, 1) = 1.0;
  const Matrix6 U = informationRoot(asymmetric);
  EXPECT_NEAR((U.transpose() * U)(1, 0), 0.5, 1e-15);
}

}  // namespace
}  // namespace revisit_slam
