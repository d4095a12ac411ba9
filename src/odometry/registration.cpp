// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/registration.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "revisit_slam/util/chunks.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kChunkLength = 256;
/// As long as the sigma is not the final one, a step that is so many times longer ends ICP.
constexpr double kCoarseConvergence = 10.0;
/// The bounds on distances are floats of values below 20 m.
constexpr double kBoundMargin = 1e-5;

/// The base during the sweep: at T_odom_base * Exp(-s * correction) for points with the sweep
/// fraction s, to first order in s.
class SweepPose {
 public:
  SweepPose(const Pose& T_odom_base, const Tangent& correction)
      : R_(T_odom_base.rotationMatrix()), t_(T_odom_base.translation) {
    const Pose T_odom_begin = T_odom_base * exp(-correction);
    turned_ = T_odom_begin.rotationMatrix() - R_;
    moved_ = T_odom_begin.translation - t_;
  }

  /// At the end of the scan.
  const Eigen::Matrix3d& R_odom_base() const { return R_; }

  Eigen::Vector3d toOdom(const Eigen::Vector3d& p_base, double fraction) const {
    return R_ * p_base + t_ + fraction * (turned_ * p_base + moved_);
  }

 private:
  Eigen::Matrix3d R_, turned_;
  Eigen::Vector3d t_, moved_;
};

struct NormalEquations {
  Matrix6 H;
  Tangent g;
};

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

  NormalEquations normalEquations() const {
    Matrix6 H;
    H << w * Eigen::Matrix3d::Identity(), -skew(wp), skew(wp),
        wpp.trace() * Eigen::Matrix3d::Identity() - wpp;
    Tangent g;
    g << wr, wpxr;
    H += plane_H;
    g += plane_g;
    return {H, g};
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
double pointWeight(const LocalShape& around, const RegistrationConfig& config) {
  if (!config.planes) return 1.0;
  if (around.kind == ShapeKind::sparse) return config.sparse_weight;
  return std::min(1.0, static_cast<double>(around.points) / config.scattered_points);
}

/// Adds a point p with r = R^T (T p - q): as one of a plane, or as a point.
void addMatch(const Eigen::Vector3d& p, const Eigen::Vector3d& r, const Eigen::Matrix3d& R,
              const LocalShape& shape, double sigma, const RegistrationConfig& config, Sums& sums) {
  const auto robust = [sigma](double squared) {
    const double root = sigma / (sigma + squared);
    return root * root;
  };
  ++sums.count;
  if (config.planes && shape.kind == ShapeKind::planar) {
    const Eigen::Vector3d n = R.transpose() * shape.normal.cast<double>();
    const double e = n.dot(r), weight = robust(e * e);
    sums.r2 += e * e;
    sums.addPlane(p, n, e, weight);
    sums.addPoint(p, r, config.within_plane_weight * weight);
  } else {
    const double squared = r.squaredNorm();
    sums.r2 += squared;
    sums.addPoint(p, r, pointWeight(shape, config) * robust(squared));
  }
}

/// The normal equations of one chunk of points at a pose.
Sums sumChunk(const Points& points_base, const std::vector<float>& sweep_fractions, Chunk chunk,
              const LocalVoxelMap& map, const SweepPose& pose, double sigma,
              const RegistrationConfig& config, std::vector<CachedMatch>& matches) {
  const Eigen::Matrix3d& R = pose.R_odom_base();
  const double max_distance = Registration::maxCorrespondenceDistance(sigma);
  Sums sums;
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Eigen::Vector3d p = points_base[i].cast<double>();
    const Eigen::Vector3d p_odom =
        pose.toOdom(p, sweep_fractions.empty() ? 0.0 : sweep_fractions[i]);
    if (!isNearMap(p_odom, map, max_distance, matches[i])) continue;
    const Neighbour& neighbour = matches[i].neighbour;
    addMatch(p, R.transpose() * (p_odom - neighbour.point_odom), R, neighbour.shape, sigma, config,
             sums);
  }
  return sums;
}

double mean(const std::vector<float>& values) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

/// The deskew correction as a linear function of how far the pose is from the prediction.
Matrix6 correctionPerDeviation(const Matrix6& H, const RegistrationConfig& config) {
  Matrix6 damped = H;
  damped.diagonal().array() += config.deskew_damping;
  return config.deskew_gain * damped.ldlt().solve(H);
}

/// A step of the pose moves the points by (1 - fraction * correction_per_deviation) of itself. The
/// mean fraction stands for all, which is near enough to converge.
Tangent stepWithCorrection(NormalEquations equations, const Tangent& deviation,
                           const Matrix6& correction_per_deviation, double mean_fraction,
                           double prediction_weight) {
  equations.H -= mean_fraction * equations.H * correction_per_deviation;
  equations.H.diagonal().array() += prediction_weight;
  equations.g += prediction_weight * deviation;
  return equations.H.fullPivLu().solve(-equations.g);
}

}  // namespace

RegistrationResult Registration::align(const Points& points_base,
                                       const std::vector<float>& sweep_fractions,
                                       const LocalVoxelMap& map, const Pose& T_odom_predicted,
                                       double sigma) {
  RegistrationResult result;
  result.T_odom_base = T_odom_predicted;
  if (map.empty()) return result;
  matches_.assign(points_base.size(), CachedMatch{});
  const Chunks chunks(points_base.size(), kChunkLength);
  std::vector<Sums> chunk_sums(chunks.size());
  const auto deviation = [&] { return log(T_odom_predicted.inverse() * result.T_odom_base); };
  const double mean_fraction = mean(sweep_fractions);
  bool has_converged_before = false;

  result.outcome = RegistrationOutcome::max_iterations;
  while (result.iterations < config_.max_iterations) {
    const SweepPose pose(result.T_odom_base, result.deskew_correction);
    chunks.forEach([&](std::size_t index, Chunk chunk) {
      chunk_sums[index] =
          sumChunk(points_base, sweep_fractions, chunk, map, pose, sigma, config_, matches_);
    });
    Sums sums;
    for (const Sums& chunk : chunk_sums) sums += chunk;
    result.correspondences = sums.count;
    if (sums.count < static_cast<std::size_t>(config_.min_correspondences)) {
      if (has_converged_before) {
        result.outcome = RegistrationOutcome::converged;
        break;
      }
      result.T_odom_base = T_odom_predicted;
      result.deskew_correction = Tangent::Zero();
      result.outcome = RegistrationOutcome::too_few_correspondences;
      return result;
    }
    result.rms_residual = std::sqrt(sums.r2 / static_cast<double>(sums.count));
    const NormalEquations equations = sums.normalEquations();
    Tangent step;
    if (sweep_fractions.empty()) {
      step = equations.H.ldlt().solve(-equations.g);
      result.T_odom_base = boxplus(result.T_odom_base, step);
    } else {
      const Matrix6 correction_per_deviation = correctionPerDeviation(equations.H, config_);
      step = stepWithCorrection(equations, deviation(), correction_per_deviation, mean_fraction,
                                config_.prediction_weight);
      result.T_odom_base = boxplus(result.T_odom_base, step);
      result.deskew_correction = correction_per_deviation * deviation();
    }
    ++result.iterations;
    const bool is_final = sigma <= config_.final_sigma;
    if (step.norm() >= (is_final ? 1.0 : kCoarseConvergence) * config_.convergence) continue;
    if (is_final) {
      result.outcome = RegistrationOutcome::converged;
      break;
    }
    sigma = std::max(config_.final_sigma, 0.5 * sigma);
    has_converged_before = true;
  }
  return result;
}

}  // namespace revisit_slam
