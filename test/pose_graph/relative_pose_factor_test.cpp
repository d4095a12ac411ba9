// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/relative_pose_factor.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/rotation.h>
#include <gtest/gtest.h>

#include "pose_graph/graph_fixtures.h"
#include "revisit_slam/pose_graph/factor_cost.h"
#include "revisit_slam/pose_graph/information_root.h"
#include "revisit_slam/pose_graph/pose_block.h"

namespace revisit_slam {
namespace {

using BlockJacobian = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;
using PlusJacobian = Eigen::Matrix<double, 7, 6, Eigen::RowMajor>;

struct Evaluation {
  Tangent residual;
  Matrix6 by_from, by_to;  ///< by right perturbations
};

Matrix6 byPerturbation(const BlockJacobian& J, const PoseBlock& block) {
  PlusJacobian plus;
  PoseChart::plusJacobian(block.data(), plus.data());
  return J * plus;
}

Evaluation evaluate(const ceres::CostFunction& cost, const Pose& T_i, const Pose& T_j) {
  const PoseBlock from = blockOf(T_i), to = blockOf(T_j);
  const double* blocks[] = {from.data(), to.data()};
  Evaluation result;
  BlockJacobian J_i, J_j;
  double* jacobians[] = {J_i.data(), J_j.data()};
  EXPECT_TRUE(cost.Evaluate(blocks, result.residual.data(), jacobians));
  result.by_from = byPerturbation(J_i, from);
  result.by_to = byPerturbation(J_j, to);
  return result;
}

/// The residual written anew with Ceres's rotations and the closed form of V^-1, for automatic
/// derivatives.
struct AutomaticCost {
  template <typename T>
  bool operator()(const T* from, const T* to, T* residual) const {
    using Quaternion = Eigen::Quaternion<T>;
    using Vector = Eigen::Matrix<T, 3, 1>;
    const Eigen::Map<const Quaternion> q_i(from), q_j(to);
    const Eigen::Map<const Vector> t_i(from + 4), t_j(to + 4);
    const Quaternion z = T_from_to.rotation.cast<T>();
    const Quaternion q = z.conjugate() * (q_i.conjugate() * q_j);
    const Vector t = z.conjugate() *
                     Vector(q_i.conjugate() * Vector(t_j - t_i) - T_from_to.translation.cast<T>());
    const T wxyz[] = {q.w(), q.x(), q.y(), q.z()};
    Vector w;
    ceres::QuaternionToAngleAxis(wxyz, w.data());
    const T angle = w.norm();
    const T c = (1.0 - 0.5 * angle * sin(angle) / (1.0 - cos(angle))) / (angle * angle);
    Eigen::Matrix<T, 6, 1> e;
    e << t - 0.5 * w.cross(t) + c * w.cross(w.cross(t)), w;
    Eigen::Map<Eigen::Matrix<T, 6, 1>>{residual} = root.cast<T>() * e;
    return true;
  }
  Pose T_from_to;
  Matrix6 root;
};

TEST(RelativePoseFactor, JacobiansEqualDifferencesAlsoOfLargeResiduals) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const RelativePoseFactor measured{
        {NodeId{0}, NodeId{1}}, random.pose(20.0), correlatedInformation(1, 1)};
    const Factor factor{measured, {}};
    const auto cost = makeCost(factor);
    const Pose T_i = random.pose(50.0);
    const Pose T_j = T_i * measured.T_from_to * exp(random.tangent(5.0, random.uniform(0.0, 2.5)));
    const Evaluation at = evaluate(*cost, T_i, T_j);
    constexpr double kStep = 1e-6;
    for (int axis = 0; axis < 6; ++axis) {
      const Tangent d = kStep * Tangent::Unit(axis);
      const Tangent by_from = evaluate(*cost, boxplus(T_i, d), T_j).residual -
                              evaluate(*cost, boxplus(T_i, -d), T_j).residual;
      const Tangent by_to = evaluate(*cost, T_i, boxplus(T_j, d)).residual -
                            evaluate(*cost, T_i, boxplus(T_j, -d)).residual;
      const double scale = 1.0 + at.by_from.norm() + at.by_to.norm();
      EXPECT_LT((by_from / (2 * kStep) - at.by_from.col(axis)).norm(), 2e-7 * scale);
      EXPECT_LT((by_to / (2 * kStep) - at.by_to.col(axis)).norm(), 2e-7 * scale);
    }
  }
}

TEST(RelativePoseFactor, ResidualsAndJacobiansEqualAutomaticOnes) {
  RandomNumbers random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const RelativePoseFactor measured{
        {NodeId{0}, NodeId{1}}, random.pose(5.0), correlatedInformation(1, 1)};
    const ceres::AutoDiffCostFunction<AutomaticCost, 6, 7, 7> automatic(
        new AutomaticCost{measured.T_from_to, informationRoot(measured.information)});
    const Pose T_i = random.pose(5.0);
    const Pose T_j = T_i * measured.T_from_to * exp(random.tangent(3.0, random.uniform(0.1, 3.0)));
    const Factor factor{measured, {}};
    const Evaluation ours = evaluate(*makeCost(factor), T_i, T_j);
    const Evaluation theirs = evaluate(automatic, T_i, T_j);
    const double scale = 1.0 + theirs.by_from.norm() + theirs.by_to.norm();
    EXPECT_LT((ours.residual - theirs.residual).norm(), 1e-11 * scale);
    EXPECT_LT((ours.by_from - theirs.by_from).norm(), 1e-10 * scale);
    EXPECT_LT((ours.by_to - theirs.by_to).norm(), 1e-10 * scale);
  }
}

TEST(RelativePoseFactor, ErrorIsTheRightPerturbationOfTheLaterNode) {
  RandomNumbers random(3);
  const Pose T_i = random.pose(10.0), Z = random.pose(10.0);
  Tangent d;
  d << 0.3, -0.2, 0.1, 0.05, -0.4, 0.2;
  const RelativePoseFactor measured{{NodeId{0}, NodeId{1}}, Z};
  EXPECT_LT((measured.error({T_i, T_i * Z * exp(d)}) - d).norm(), 1e-12);
}

TEST(RelativePoseFactor, InformationCountsInTheFrameOfTheLaterNode) {
  RelativePoseFactor measured{{NodeId{0}, NodeId{1}}, {}};
  measured.T_from_to = {expSO3({0.0, 0.0, M_PI / 2}), {5.0, 0.0, 0.0}};
  measured.information.diagonal() << 100.0, 1.0, 1.0, 1.0, 1.0, 1.0;  // x of j is y of i
  const Pose T_i, T_j = T_i * measured.T_from_to;
  const Pose along_x_of_j{T_j.rotation, T_j.translation + Eigen::Vector3d(0, 0.1, 0)};
  const Pose along_y_of_j{T_j.rotation, T_j.translation + Eigen::Vector3d(0.1, 0, 0)};
  const Factor factor{measured, {}};
  EXPECT_NEAR(factor.chi2({T_i, along_x_of_j}), 1.0, 1e-12);
  EXPECT_NEAR(factor.chi2({T_i, along_y_of_j}), 0.01, 1e-12);
}

TEST(RelativePoseFactor, CorrelationsKeepTheirSign) {
  RelativePoseFactor measured{{NodeId{0}, NodeId{1}}, {}};
  measured.information(0, 5) = measured.information(5, 0) = 0.9;
  Tangent same = Tangent::Zero(), opposite = Tangent::Zero();
  same[0] = same[5] = opposite[0] = 1e-3;
  opposite[5] = -1e-3;
  const Factor factor{measured, {}};
  EXPECT_NEAR(factor.chi2({Pose(), exp(same)}), 3.8e-6, 1e-12);
  EXPECT_NEAR(factor.chi2({Pose(), exp(opposite)}), 0.2e-6, 1e-12);
  const Tangent r = evaluate(*makeCost(factor), {}, exp(same)).residual;
  EXPECT_NEAR(r.squaredNorm(), 3.8e-6, 1e-12);
}

}  // namespace
}  // namespace revisit_slam
