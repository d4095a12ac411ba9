// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/registration/fine_registration_objective.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

const Eigen::Vector3f kNone = Eigen::Vector3f::Zero();
const Eigen::Vector3f kUp = Eigen::Vector3f::UnitZ();

NormalEquations add(const Surfel& source, const Surfel& target) {
  NormalEquations equations;
  FineRegistrationObjective(5.0).add(source, target, SurfelPose(Pose::identity()), equations);
  return equations;
}

TEST(FineRegistrationObjective, IsPointToPlaneWhereEitherSurfelHasANormal) {
  const Eigen::Vector3f p(4, 2, 1), q(4.5, 2, 0.5);
  for (const auto& [a, b] : {std::pair{kUp, kNone}, {kNone, kUp}, {kUp, kUp}}) {
    const NormalEquations equations = add({p, a}, {q, b});
    EXPECT_NEAR(equations.rms(), 0.5, 1e-6);
    EXPECT_NEAR(equations.weight(), GemanMcClure::ofScale(1.0).weight(0.25), 1e-6);
    EXPECT_EQ(equations.H()(0, 0), 0.0);
  }
}

TEST(FineRegistrationObjective, IsPointToPointOfASmallWeightWithoutNormals) {
  const Eigen::Vector3d p(4, 2, 1), r(-0.5, 0, 0.5);
  const NormalEquations equations = add({p.cast<float>(), kNone}, {(p - r).cast<float>(), kNone});
  const double weight = 0.1 * GemanMcClure::ofScale(1.0).weight(r.squaredNorm());
  NormalEquations expected;
  expected.add(PointToPoint{p, r}, weight);
  EXPECT_LT((equations.H() - expected.H()).norm(), 1e-6);
  EXPECT_LT((equations.g() - expected.g()).norm(), 1e-6);
  EXPECT_EQ(equations.matches(), 1u);
}

TEST(FineRegistrationObjective, ADirectionWithoutConstraintsStaysWhereItIs) {
  RandomNumbers random(1);
  NormalEquations equations;
  for (int i = 0; i < 100; ++i)
    equations.add(PointToPlane{random.inCube(20.0), Eigen::Vector3d::UnitZ(), 0.2}, 1.0);
  const Tangent step = dampedStep(equations);
  EXPECT_NEAR(step.z(), -0.2, 1e-3);
  for (const int along : {0, 1, 5}) EXPECT_NEAR(step[along], 0.0, 1e-9);
}

}  // namespace
}  // namespace revisit_slam
