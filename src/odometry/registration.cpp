// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/registration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "revisit_slam/geometry/chunks.h"
#include "revisit_slam/geometry/se3.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kChunkLength = 256;
/// The bounds on distances are floats of values below 20 m.
constexpr double kBoundMargin = 1e-5;

/// Sums over correspondences of which the normal equations consist. The residual of a point is
/// r = R^T (T p - q) in the base frame with the Jacobian [I, -skew(p)], that of a plane with the
/// normal n in the base frame e = n^T r with [n; p x n]^T.
struct Sums {
  double w = 0.0, r2 = 0.0;
  Eigen::Vector3d wp = Eigen::Vector3d::Zero(), wr = Eigen::Vector3d::Zero();
  Eigen::Vector3d wpxr = Eigen::Vector3d::Zero();
  Eigen::Matrix3d wpp = Eigen::Matrix3d::Zero();
  Matrix6 plane_H = Matrix6::Zero();
  Tangent plane_g = Tangent::Zero();
  std::size_t count = 0;

  void addPoint(const Eigen::Vector3d& p, const Eigen::Vector3d& r, double weight) {
    w += weight;
    wp += weight * p;
    wr += weight * r;
    wpxr += weight * p.cross(r);
    wpp += (weight * p) * p.transpose();
  }

  void addPlane(const Eigen::Vector3d& p, const Eigen::Vector3d& n, double e, double weight) {
    Tangent J;
    J << n, p.cross(n);
    const Tangent weighted = weight * J;
    plane_H.noalias() += weighted * J.transpose();
    plane_g += e * weighted;
  }

  Sums& operator+=(const Sums& other) {
    w += other.w;
    r2 += other.r2;
    wp += other.wp;
    wr += other.wr;
    wpxr += other.wpxr;
    wpp += other.wpp;
    plane_H += other.plane_H;
    plane_g += other.plane_g;
    count += other.count;
    return *this;
  }

  Tangent gaussNewtonStep() const {
    Matrix6 H;
    H << w * Eigen::Matrix3d::Identity(), -skew(wp), skew(wp),
        wpp.trace() * Eigen::Matrix3d::Identity() - wpp;
    Tangent g;
    g << wr, wpxr;
    H += plane_H;
    g += plane_g;
    return H.ldlt().solve(-g);
  }
};

/// Whether a map point is nearer than `max_distance`; the nearest is then in `match`. It is looked
/// up anew only where the one found before may no longer be the nearest.
bool isNearMap(const Eigen::Vector3d& p_odom, const LocalVoxelMap& map, double max_distance,
               CachedMatch& match) {
  if (match.valid) {
    const double distance = (p_odom - match.neighbour.point_odom).norm();
    const double moved = (p_odom - match.searched_at).norm();
    if (distance + moved + kBoundMargin <= match.neighbour.rival_distance)
      return distance < max_distance;
  }
  match.searched_at = p_odom;
  match.valid = map.nearest(p_odom, max_distance, match.neighbour);
  return match.valid && (p_odom - match.neighbour.point_odom).norm() < max_distance;
}

/// The denser the map, the less the nearest point depends on where rays fell.
double pointWeight(const Surroundings& around, const RegistrationConfig& config) {
  if (!config.planes) return 1.0;
  if (around.spread == Spread::sparse) return config.sparse_weight;
  return std::min(1.0, static_cast<double>(around.points) / config.scattered_points);
}

/// Adds a point p with r = R^T (T p - q): as one of a plane, or as a point.
void addMatch(const Eigen::Vector3d& p, const Eigen::Vector3d& r, const Eigen::Matrix3d& R,
              const Surroundings& surroundings, double sigma, const RegistrationConfig& config,
              Sums& sums) {
  const auto robust = [sigma](double squared) {
    const double root = sigma / (sigma + squared);
    return root * root;
  };
  ++sums.count;
  if (config.planes && surroundings.spread == Spread::planar) {
    const Eigen::Vector3d n = R.transpose() * surroundings.normal.cast<double>();
    const double e = n.dot(r), weight = robust(e * e);
    sums.r2 += e * e;
    sums.addPlane(p, n, e, weight);
    sums.addPoint(p, r, config.within_plane_weight * weight);
  } else {
    const double squared = r.squaredNorm();
    sums.r2 += squared;
    sums.addPoint(p, r, pointWeight(surroundings, config) * robust(squared));
  }
}

/// The normal equations of one chunk of points at T_odom_base.
Sums sumChunk(const Points& points_base, Chunk chunk, const LocalVoxelMap& map,
              const Pose& T_odom_base, double sigma, const RegistrationConfig& config,
              std::vector<CachedMatch>& matches) {
  const Eigen::Matrix3d R = T_odom_base.rotationMatrix();
  const double max_distance = Registration::maxCorrespondenceDistance(sigma);
  Sums sums;
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Eigen::Vector3d p = points_base[i].cast<double>();
    const Eigen::Vector3d p_odom = R * p + T_odom_base.translation;
    if (!isNearMap(p_odom, map, max_distance, matches[i])) continue;
    const Neighbour& neighbour = matches[i].neighbour;
    addMatch(p, R.transpose() * (p_odom - neighbour.point_odom), R, neighbour.surroundings, sigma,
             config, sums);
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
      chunk_sums[index] = sumChunk(points_base, chunk, map, result.T_odom_base, sigma,
                                    config_, matches_);
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
