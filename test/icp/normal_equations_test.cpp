// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/normal_equations.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

/// Sums of dense products beside those of NormalEquations.
struct Reference {
  NormalEquations equations;
  Matrix6 H = Matrix6::Zero();
  Tangent g = Tangent::Zero();

  void add(const PointToPoint& residual, double weight) {
    equations.add(residual, weight);
    H += weight * residual.jacobian().transpose() * residual.jacobian();
    g += weight * residual.jacobian().transpose() * residual.r;
  }
  void add(const PointToPlane& residual, double weight) {
    equations.add(residual, weight);
    H += weight * residual.jacobian() * residual.jacobian().transpose();
    g += weight * residual.jacobian() * residual.e;
  }
  void expectEqual() const {
    EXPECT_LT((equations.H() - H).norm(), 1e-12 * H.norm());
    EXPECT_LT((equations.g() - g).norm(), 1e-12 * g.norm());
  }
};

PointToPoint randomPoint(RandomNumbers& random) {
  return {random.inCube(30.0), random.inCube(1.0)};
}

PointToPlane randomPlane(RandomNumbers& random) {
  return {random.inCube(30.0), random.direction(), random.uniform(-1.0, 1.0)};
}

TEST(NormalEquations, OfPointsEqualDenseProducts) {
  RandomNumbers random(1);
  Reference reference;
  for (int i = 0; i < 50; ++i) reference.add(randomPoint(random), random.uniform(0.0, 1.0));
  reference.expectEqual();
}

TEST(NormalEquations, OfPlanesEqualDenseProducts) {
  RandomNumbers random(2);
  Reference reference;
  for (int i = 0; i < 50; ++i) reference.add(randomPlane(random), random.uniform(0.0, 1.0));
  reference.expectEqual();
}

TEST(NormalEquations, OfBothAndOfPartsAreSums) {
  RandomNumbers random(3);
  Reference whole;
  NormalEquations first, second;
  double weights = 0.0;
  for (int i = 0; i < 40; ++i) {
    const PointToPoint point = randomPoint(random);
    const PointToPlane plane = randomPlane(random);
    const double weight = random.uniform(0.0, 1.0);
    NormalEquations& part = i < 15 ? first : second;
    whole.add(point, weight);
    whole.add(plane, 2.0 * weight);
    part.add(point, weight);
    part.add(plane, 2.0 * weight);
    part.countRing(weight);
    weights += 3.0 * weight;
  }
  whole.expectEqual();
  first += second;
  EXPECT_LT((first.H() - whole.H).norm(), 1e-12 * whole.H.norm());
  EXPECT_LT((first.g() - whole.g).norm(), 1e-12 * whole.g.norm());
  EXPECT_NEAR(first.weight(), weights, 1e-9);
  EXPECT_NEAR(first.ringWeight(), weights / 3.0, 1e-9);
}

TEST(NormalEquations, CountMatchesAndTheirResidualsOnce) {
  NormalEquations first, second;
  first.countMatch(0.09);
  second.countMatch(0.25);
  second.add(PointToPlane{{1, 0, 0}, {0, 0, 1}, 0.5}, 0.1);
  second.add(PointToPoint{{1, 0, 0}, {0, 0, 0.5}}, 0.1);
  first += second;
  EXPECT_EQ(first.matches(), 2u);
  EXPECT_NEAR(first.rms(), std::sqrt(0.17), 1e-12);
}

TEST(NormalEquations, CountWhatIsExplained) {
  NormalEquations first, second;
  first.countExplained(false);
  second.countExplained(true);
  first += second;
  EXPECT_EQ(first.explained(), 2u);
  EXPECT_EQ(first.explainedAlike(), 1u);
}

}  // namespace
}  // namespace revisit_slam
