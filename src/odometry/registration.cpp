// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/registration.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <optional>

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

/// Distance from a point to its nearest map point, looked up anew only where the cached one may no
/// longer be the nearest; nothing where none is nearer than `max_distance`.
std::optional<double> distanceToNearest(const Eigen::Vector3d& p_odom, const LocalVoxelMap& map,
                                        double max_distance, CachedMatch& match) {
  if (match.valid) {
    const double distance = (p_odom - match.neighbour.point_odom).norm();
    const double moved = (p_odom - match.searched_at).norm();
    if (distance + moved + kBoundMargin <= match.neighbour.rival_distance)
      return distance < max_distance ? std::optional<double>(distance) : std::nullopt;
  }
  match.searched_at = p_odom;
  match.valid = map.nearest(p_odom, max_distance, match.neighbour);
  if (!match.valid) return std::nullopt;
  const double distance = (p_odom - match.neighbour.point_odom).norm();
  return distance < max_distance ? std::optional<double>(distance) : std::nullopt;
}

/// The normal equations of one chunk of points at T_odom_base.
Sums sumChunk(const Points& points_base, Chunk chunk, const LocalVoxelMap& map,
              const Pose& T_odom_base, double sigma, std::vector<CachedMatch>& matches) {
  const Eigen::Matrix3d R = T_odom_base.rotationMatrix();
  const double max_distance = Registration::maxCorrespondenceDistance(sigma);
  Sums sums;
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Eigen::Vector3d p = points_base[i].cast<double>();
    const Eigen::Vector3d p_odom = R * p + T_odom_base.translation;
    const auto distance = distanceToNearest(p_odom, map, max_distance, matches[i]);
    if (!distance) continue;
    const double squared = *distance * *distance;
    const double root_weight = sigma / (sigma + squared);
    sums.add(p, R.transpose() * (p_odom - matches[i].neighbour.point_odom), squared,
             root_weight * root_weight);
  }
  return sums;
}

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
  matches_.assign(points_base.size(), CachedMatch{});
  const Chunks chunks(points_base.size(), kChunkLength);
  std::vector<Sums> chunk_sums(chunks.size());

  result.outcome = RegistrationOutcome::max_iterations;
  while (result.iterations < config_.max_iterations) {
    chunks.forEach([&](std::size_t index, Chunk chunk) {
      chunk_sums[index] = sumChunk(points_base, chunk, map, result.T_odom_base, sigma, matches_);
    });
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
