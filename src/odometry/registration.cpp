// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/registration.h"

#include <Eigen/Cholesky>

#include "revisit_slam/geometry/chunks.h"
#include "revisit_slam/geometry/se3.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kChunkLength = 256;
/// The bounds on distances are floats of values below 20 m.
constexpr double kBoundMargin = 1e-5;

/// Sums over correspondences of which the normal equations consist. With the residual
/// r = R^T (T p - q) in the base frame, its Jacobian is [I, -skew(p)].
struct Sums {
  double w = 0.0, r2 = 0.0;
  Eigen::Vector3d wp = Eigen::Vector3d::Zero(), wr = Eigen::Vector3d::Zero();
  Eigen::Vector3d wpxr = Eigen::Vector3d::Zero();
  Eigen::Matrix3d wpp = Eigen::Matrix3d::Zero();
  std::size_t count = 0;

  void add(const Eigen::Vector3d& p, const Eigen::Vector3d& r, double squared, double weight) {
    w += weight;
    r2 += squared;
    wp += weight * p;
    wr += weight * r;
    wpxr += weight * p.cross(r);
    wpp += (weight * p) * p.transpose();
    ++count;
  }

  Sums& operator+=(const Sums& other) {
    w += other.w;
    r2 += other.r2;
    wp += other.wp;
    wr += other.wr;
    wpxr += other.wpxr;
    wpp += other.wpp;
    count += other.count;
    return *this;
  }

  Tangent gaussNewtonStep() const {
    Matrix6 H;
    H << w * Eigen::Matrix3d::Identity(), -skew(wp), skew(wp),
        wpp.trace() * Eigen::Matrix3d::Identity() - wpp;
    Tangent g;
    g << wr, wpxr;
    return H.ldlt().solve(-g);
  }
};

}  // namespace

const char* toString(RegistrationOutcome outcome) {
  switch (outcome) {
    case RegistrationOutcome::converged: return "converged";
    case RegistrationOutcome::max_iterations: return "stopped at the largest number of iterations";
    case RegistrationOutcome::too_few_correspondences: return "too few correspondences";
    case RegistrationOutcome::map_empty: return "first scan";
  }
  return "unknown";
}

RegistrationResult Registration::align(const Points& points_base, const LocalVoxelMap& map,
                                       const Pose& T_odom_initial, double sigma) {
  RegistrationResult result;
  result.T_odom_base = T_odom_initial;
  if (map.empty()) return result;
  matches_.assign(points_base.size(), Match{});
  const double max_distance = maxCorrespondenceDistance(sigma);
  const Chunks chunks(points_base.size(), kChunkLength);
  std::vector<Sums> chunk_sums(chunks.size());

  const auto sumChunk = [&](std::size_t index, Chunk chunk) {
    const Eigen::Matrix3d R = result.T_odom_base.rotationMatrix();
    Sums sums;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Eigen::Vector3d p = points_base[i].cast<double>();
      const Eigen::Vector3d p_odom = R * p + result.T_odom_base.translation;
      Match& match = matches_[i];
      double distance = (p_odom - match.neighbour.point_odom).norm();
      const double moved = (p_odom - match.searched_at).norm();
      if (!match.valid || distance + moved + kBoundMargin > match.neighbour.rival_distance) {
        match.searched_at = p_odom;
        match.valid = map.nearest(p_odom, max_distance, match.neighbour);
        if (!match.valid) continue;
        distance = (p_odom - match.neighbour.point_odom).norm();
      }
      if (distance >= max_distance) continue;
      const double squared = distance * distance;
      const double root_weight = sigma / (sigma + squared);
      sums.add(p, R.transpose() * (p_odom - match.neighbour.point_odom), squared,
               root_weight * root_weight);
    }
    chunk_sums[index] = sums;
  };

  result.outcome = RegistrationOutcome::max_iterations;
  while (result.iterations < config_.max_iterations) {
    chunks.forEach(sumChunk);
    Sums sums;
    for (const Sums& chunk : chunk_sums) sums += chunk;
    result.correspondences = sums.count;
    if (sums.count < static_cast<std::size_t>(config_.min_correspondences)) {
      result.T_odom_base = T_odom_initial;
      result.outcome = RegistrationOutcome::too_few_correspondences;
      return result;
    }
    result.rms_residual = std::sqrt(sums.r2 / static_cast<double>(sums.count));
    const Tangent step = sums.gaussNewtonStep();
    result.T_odom_base = boxplus(result.T_odom_base, step);
    ++result.iterations;
    if (step.norm() < config_.convergence) {
      result.outcome = RegistrationOutcome::converged;
      break;
    }
  }
  return result;
}

}  // namespace revisit_slam
