// SPDX-License-Identifier: MIT
#include "revisit_slam/types/se3.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

/// Both sides of every switch from a series to the closed form, and close to pi.
constexpr double kAngles[] = {0.0,     1e-12,       1e-8,        0.99e-4,    1.01e-4, 1.99e-4,
                              2.01e-4, 0.99e-2,     1.01e-2,     0.1,        1.0,     2.5,
                              3.0,     M_PI - 1e-3, M_PI - 1e-6, M_PI - 1e-9};

template <typename Check>
void forTangents(double half_translation, const Check& check) {
  RandomNumbers random(7);
  for (const double angle : kAngles)
    for (int i = 0; i < 20; ++i) {
      SCOPED_TRACE("angle " + std::to_string(angle));
      check(random.tangent(half_translation, angle), random);
    }
}

TEST(Se3, ExponentialOfZeroIsTheIdentity) {
  EXPECT_EQ(exp(Tangent::Zero()).matrix(), Eigen::Matrix4d::Identity());
  EXPECT_EQ(log(Pose::identity()), Tangent::Zero());
}

TEST(Se3, LogarithmUndoesTheExponential) {
  forTangents(10.0, [](const Tangent& t, RandomNumbers&) {
    const Pose T = exp(t);
    EXPECT_NEAR(T.rotation.norm(), 1.0, 1e-14);
    EXPECT_LT((log(T) - t).norm(), 1e-11);
    EXPECT_LT((exp(log(T)).matrix() - T.matrix()).norm(), 1e-11);
  });
}

TEST(Se3, ExponentialIsTheMatrixExponential) {
  forTangents(1.0, [](const Tangent& t, RandomNumbers&) {
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
    A.topLeftCorner<3, 3>() = skew(t.tail<3>());
    A.topRightCorner<3, 1>() = t.head<3>();
    Eigen::Matrix4d term = Eigen::Matrix4d::Identity(), sum = term;
    for (int n = 1; n < 40; ++n) sum += term = term * A / n;
    EXPECT_LT((exp(t).matrix() - sum).norm(), 1e-11);
  });
}

TEST(Se3, LogarithmDoesNotSeeTheSignOfTheQuaternion) {
  forTangents(10.0, [](const Tangent& t, RandomNumbers&) {
    Pose T = exp(t);
    const Tangent expected = log(T);
    T.rotation.coeffs() *= -1.0;
    EXPECT_EQ(log(T), expected);
  });
}

TEST(Se3, LogarithmTurnsTheShortWay) {
  RandomNumbers random(8);
  for (const double angle : {M_PI, M_PI + 1e-6, 4.0, 6.0, 2.0 * M_PI}) {
    const Tangent t = random.tangent(1.0, angle);
    EXPECT_LE(log(exp(t)).tail<3>().norm(), M_PI + 1e-15);
    EXPECT_LT((exp(log(exp(t))).matrix() - exp(t).matrix()).norm(), 1e-9);
  }
}

TEST(Se3, AdjointMovesAPerturbationToTheOtherSide) {
  forTangents(10.0, [](const Tangent& t, RandomNumbers& random) {
    const Pose T = exp(t);
    const Tangent d = random.tangent(1.0, 0.5);
    EXPECT_LT(((T * exp(d)).matrix() - (exp(adjoint(T) * d) * T).matrix()).norm(), 1e-11);
    EXPECT_LT((adjoint(T * exp(d)) - adjoint(T) * adjoint(exp(d))).norm(), 1e-10);
  });
}

TEST(Se3, BoxplusPerturbsInTheBodyFrame) {
  const Pose T{expSO3({0, 0, M_PI / 2}), {1000, 0, 0}};
  Tangent forward = Tangent::Zero();
  forward.x() = 2.0;
  EXPECT_LT((boxplus(T, forward).translation - Eigen::Vector3d(1000, 2, 0)).norm(), 1e-12);
}

TEST(Se3, SkewIsTheCrossProduct) {
  RandomNumbers random(9);
  const Eigen::Vector3d a = random.inCube(1.0), b = random.inCube(1.0);
  EXPECT_LT((skew(a) * b - a.cross(b)).norm(), 1e-15);
}

TEST(Se3, LeftJacobianOfRotationsMatchesNumericDifferences) {
  forTangents(1.0, [](const Tangent& t, RandomNumbers&) {
    const Eigen::Vector3d w = t.tail<3>();
    Eigen::Matrix3d numeric;
    constexpr double h = 1e-5;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d d = h * Eigen::Vector3d::Unit(axis);
      numeric.col(axis) = logSO3(expSO3(w + d) * expSO3(w - d).conjugate()) / (2.0 * h);
    }
    EXPECT_LT((leftJacobianSO3(w) - numeric).norm(), 1e-9);
    EXPECT_LT((leftJacobianInverseSO3(w) * leftJacobianSO3(w) - Eigen::Matrix3d::Identity()).norm(),
              1e-10);
  });
}

TEST(Se3, RightJacobianInverseMatchesNumericDifferences) {
  forTangents(3.0, [](const Tangent& t, RandomNumbers&) {
    if (t.tail<3>().norm() > 3.1) return;  // a difference would step over pi
    Matrix6 numeric;
    constexpr double h = 1e-5;
    for (int axis = 0; axis < 6; ++axis) {
      const Tangent d = h * Tangent::Unit(axis);
      numeric.col(axis) = (log(boxplus(exp(t), d)) - log(boxplus(exp(t), -d))) / (2.0 * h);
    }
    EXPECT_LT((rightJacobianInverse(t) - numeric).norm(), 1e-6);
  });
}

}  // namespace
}  // namespace revisit_slam
