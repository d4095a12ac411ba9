// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/deskew_correction.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "revisit_slam/util/chunks.h"
#include "revisit_slam/util/vector_clones.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kChunkLength = 8192;

Matrix6 correctionPerDeviation(const Matrix6& H, const RegistrationConfig& config) {
  Matrix6 damped = H;
  damped.diagonal().array() += config.deskew_damping;
  return config.deskew_gain * damped.ldlt().solve(H);
}

}  // namespace

/// p += fraction * (A * p + t), the sums in the order of Eigen's. `points`: x, y, z of each.
REVISIT_SLAM_VECTOR_CLONES
void addFractions(const float* fractions, std::size_t count, const Eigen::Matrix3f& A,
                  const Eigen::Vector3f& t, float* __restrict points) {
  const float a00 = A(0, 0), a01 = A(0, 1), a02 = A(0, 2), t0 = t[0];
  const float a10 = A(1, 0), a11 = A(1, 1), a12 = A(1, 2), t1 = t[1];
  const float a20 = A(2, 0), a21 = A(2, 1), a22 = A(2, 2), t2 = t[2];
  for (std::size_t i = 0; i < count; ++i) {
    const float x = points[3 * i], y = points[3 * i + 1], z = points[3 * i + 2];
    points[3 * i] = x + fractions[i] * ((a00 * x + (a01 * y + a02 * z)) + t0);
    points[3 * i + 1] = y + fractions[i] * ((a10 * x + (a11 * y + a12 * z)) + t1);
    points[3 * i + 2] = z + fractions[i] * ((a20 * x + (a21 * y + a22 * z)) + t2);
  }
}

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
    addFractions(&sweep_fractions[chunk.begin], chunk.end - chunk.begin, turned, moved,
                 points_base[chunk.begin].data());
  });
}

}  // namespace revisit_slam
