// SPDX-License-Identifier: MIT
#include "revisit_slam/information/perturbation_design.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

TEST(PerturbationDesign, RecoversAnyQuadraticExactly) {
  for (const bool full : {false, true}) {
    InformationConfig config;
    config.full = full;
    for (const PerturbationDesign& design : makeDesigns(config)) {
      const int first = design.firstAxis(), axes = full ? 6 : 3;
      const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(
          axes, axes,
          [](Eigen::Index i, Eigen::Index j) { return std::sin(1.0 + 3.0 * i + 7.0 * j); });
      const Eigen::MatrixXd H = root * root.transpose();  // correlated
      const Eigen::VectorXd g = root.col(0);
      Eigen::VectorXd b(design.samples().size());
      for (Eigen::Index m = 0; m < b.size(); ++m) {
        const Eigen::VectorXd d =
            design.samples()[static_cast<std::size_t>(m)].segment(first, axes);
        b[m] = d.dot(g) + 0.5 * d.dot(H * d);
      }
      const QuadraticFit fit = design.fit(b);
      EXPECT_LT((fit.hessian - H).norm(), 1e-6 * H.norm());
      EXPECT_LT((fit.gradient - g).norm(), 1e-8 * g.norm());
    }
  }
}

TEST(PerturbationDesign, IsAntipodalAndWithinItsRanges) {
  const InformationConfig config;
  for (const PerturbationDesign& design : makeDesigns(config)) {
    ASSERT_EQ(design.samples().size(), 30u);
    for (std::size_t m = 0; m < design.samples().size(); m += 2) {
      EXPECT_EQ(design.samples()[m], -design.samples()[m + 1]);
      EXPECT_LE(design.samples()[m].head<3>().cwiseAbs().maxCoeff(), design.translationRange());
      EXPECT_LE(design.samples()[m].tail<3>().cwiseAbs().maxCoeff(), design.rotationRange());
    }
  }
}

}  // namespace
}  // namespace revisit_slam
