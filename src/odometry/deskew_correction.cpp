// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/deskew_correction.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kChunkLength = 8192;

Matrix6 correctionPerDeviation(const Matrix6& H, const RegistrationConfig& config) {
  Matrix6 damped = H;
  damped.diagonal().array() += config.deskew_damping;
  return config.deskew_gain * damped.ldlt().solve(H);
}

}  // namespace

SweepPose::SweepPose(const Pose& T_odom_base, const Tangent& correction)
    : R_(T_odom_base.rotationMatrix()), t_(T_odom_base.translation) {
  const Pose T_odom_begin = T_odom_base * exp(-correction);
  turned_ = T_odom_begin.rotationMatrix() - R_;
  moved_ = T_odom_begin.translation - t_;
}

/// A step of the pose moves the points by (1 - fraction * correction_per_deviation) of itself. The
/// mean fraction stands for all, which is near enough to converge.
DeskewedStep deskewedStep(const NormalEquations& equations, const Tangent& deviation,
                          const Matrix6& prediction_weight, double mean_sweep_fraction,
                          const RegistrationConfig& config) {
  Matrix6 H = equations.H();
  Tangent g = equations.g();
  DeskewedStep result;
  result.correction_per_deviation = correctionPerDeviation(H, config);
  H -= mean_sweep_fraction * H * result.correction_per_deviation;
  H += prediction_weight;
  g += prediction_weight * deviation;
  result.step = H.fullPivLu().solve(-g);
  return result;
}

void applyDeskewCorrection(Points& points_base, const std::vector<float>& sweep_fractions,
                           const Tangent& correction) {
  const Pose T_end_begin = exp(-correction);
  const Eigen::Matrix3f turned =
      (T_end_begin.rotationMatrix() - Eigen::Matrix3d::Identity()).cast<float>();
  const Eigen::Vector3f moved = T_end_begin.translation.cast<float>();
  Chunks(points_base.size(), kChunkLength).forEach([&](std::size_t, Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      points_base[i] += sweep_fractions[i] * (turned * points_base[i] + moved);
  });
}

}  // namespace revisit_slam
