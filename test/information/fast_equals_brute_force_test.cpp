// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "revisit_slam/information/information_estimator.h"
#include "support/brute_force_objective.h"
#include "support/information_scenes.h"

namespace revisit_slam {
namespace {

constexpr double kTau = 0.8;

class FastEqualsBruteForce : public ::testing::TestWithParam<bool> {};

TEST_P(FastEqualsBruteForce, ToTheLastBit) {
  InformationConfig config;
  config.full = GetParam();
  const std::vector<PerturbationDesign> designs = makeDesigns(config);
  for (Scene scene : {makePlane(), makeCorridor(), makeCorner()}) {
    const Pose T{expSO3({0.1, -0.2, 2.0}), {1234.5, -876.5, 12.3}};
    const LocalVoxelMap map = scene.map(T);
    const Pose T_off =
        boxplus(T, (Tangent() << 0.05, -0.03, 0.04, 0.004, -0.003, 0.002).finished());
    const RegistrationProblem fast =
        gatherProblem(scene.points_base, map, T_off, kTau, 300, designs);
    const RegistrationProblem brute = withAllCandidates(fast, map, T_off);
    for (std::size_t k = 0; k < designs.size(); ++k) {
      const ObjectiveSampling sampling(designs[k], k);
      const Eigen::VectorXd a = sampling.evaluate(fast), b = sampling.evaluate(brute);
      for (Eigen::Index m = 0; m < a.size(); ++m) ASSERT_EQ(a[m], b[m]) << "sample " << m;
    }
    std::size_t kept = 0, offered = 0;
    for (std::size_t c = 0; c < fast.chunks.size(); ++c) {
      kept += fast.chunks[c][0].relative_base.size();
      offered += brute.chunks[c][0].relative_base.size();
    }
    EXPECT_LT(4 * kept, offered);  // something was left out
  }
}

INSTANTIATE_TEST_SUITE_P(Designs, FastEqualsBruteForce, ::testing::Values(false, true));

/// The objective by another way: a search of the map at the perturbed pose, for each sample.
TEST(ObjectiveSampling, IsTheObjectiveAtThePerturbedPose) {
  const InformationConfig config;
  const std::vector<PerturbationDesign> designs = makeDesigns(config);
  Scene scene = makeCorner();
  const Pose T{expSO3({0.0, 0.1, -1.0}), {10.0, 20.0, 1.0}};
  const LocalVoxelMap map = scene.map(T);
  const RegistrationProblem problem =
      gatherProblem(scene.points_base, map, T, kTau, 1000000, designs);
  for (std::size_t k = 0; k < designs.size(); ++k) {
    const Eigen::VectorXd chi = ObjectiveSampling(designs[k], k).evaluate(problem);
    for (Eigen::Index m = 0; m + 1 < chi.size(); m += 7) {
      const Pose T_sample = boxplus(T, designs[k].samples()[static_cast<std::size_t>(m)]);
      double expected = 0.0;
      for (const Eigen::Vector3f& p : scene.points_base) {
        Neighbour neighbour;
        const bool found = map.nearest(T_sample * p.cast<double>(), kTau, neighbour);
        expected += found ? neighbour.distance * neighbour.distance : kTau * kTau;
      }
      EXPECT_NEAR(chi[m], expected, 1e-3 * expected);
    }
  }
}

}  // namespace
}  // namespace revisit_slam
