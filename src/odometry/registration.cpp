// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/registration.h"

#include <Eigen/Cholesky>
#include <numeric>

#include "revisit_slam/odometry/annealed_sigma.h"
#include "revisit_slam/odometry/deskew_correction.h"
#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kChunkLength = 256;
/// m^2 over the weight of the matches is the variance of what they add up to. Far above the noise
/// of a range, as matches nearby share their errors.
constexpr double kMatchVariance = 0.003;
/// Of a point on what is alike at many places, beside others: how much it tells of the fit.
constexpr double kWeightOfAlike = 0.1;

/// What is registered; sweep fractions may be missing.
struct Source {
  const Points& points_base;
  const std::vector<float>& sweep_fractions;
  const std::vector<AcrossRings>& across;
  double mean_fraction;

  double fraction(std::size_t i) const {
    return sweep_fractions.empty() ? 0.0 : sweep_fractions[i];
  }
};

double mean(const std::vector<float>& values) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

/// Matches the points of a chunk and adds up their normal equations.
NormalEquations lineariseChunk(const Source& source, Chunk chunk, const LocalVoxelMap& map,
                               const SweepPose& pose, const ScanObjective& objective,
                               std::vector<CachedMatch>& matches) {
  const Eigen::Matrix3d& R = pose.R_odom_base();
  const double max_distance = objective.maxDistance();
  NormalEquations equations;
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Eigen::Vector3d p = source.points_base[i].cast<double>();
    const Eigen::Vector3d p_odom = pose.toOdom(p, source.fraction(i));
    if (!matches[i].update(p_odom, map, max_distance)) continue;
    const Neighbour& neighbour = matches[i].neighbour();
    const Eigen::Vector3d r = R.transpose() * (p_odom - neighbour.point_odom);
    objective.add({p, r}, neighbour.shape, source.across[i], R, equations);
  }
  return equations;
}

NormalEquations linearise(const Source& source, const LocalVoxelMap& map, const SweepPose& pose,
                          const ScanObjective& objective, std::vector<CachedMatch>& matches) {
  const Chunks chunks(source.points_base.size(), kChunkLength);
  std::vector<NormalEquations> parts(chunks.size());
  chunks.forEach([&](std::size_t index, Chunk chunk) {
    parts[index] = lineariseChunk(source, chunk, map, pose, objective, matches);
  });
  NormalEquations sum;
  for (const NormalEquations& part : parts) sum += part;
  return sum;
}

/// The predicted pose, and its weight in units of those of the matches.
struct WeighedPrediction {
  const Pose& T_odom_base;
  Matrix6 weight;
};

/// Without information the weight is that of the configuration, in deskewed scans.
WeighedPrediction weighed(const PosePrediction& predicted, bool deskewed, const RingLimit& rings,
                          const RegistrationConfig& config) {
  Matrix6 weight = Matrix6::Zero();
  if (predicted.information) {
    weight = kMatchVariance * *predicted.information;
  } else if (deskewed) {
    weight.diagonal().setConstant(config.prediction_weight);
    weight = rings.limited(weight);
  }
  return {predicted.T_odom_base, weight};
}

double shareExplained(const NormalEquations& equations, std::size_t points,
                      double weight_of_alike) {
  const double alike = (1.0 - weight_of_alike) * static_cast<double>(equations.explainedAlike());
  return (static_cast<double>(equations.explained()) - alike) /
         (static_cast<double>(points) - alike);
}

/// Moves the pose, and with sweep fractions the deskew correction. @return the step.
Tangent takeStep(const NormalEquations& equations, const Source& source,
                 const WeighedPrediction& prediction, const RegistrationConfig& config,
                 RegistrationResult& result) {
  const auto deviation = [&] { return log(prediction.T_odom_base.inverse() * result.T_odom_base); };
  if (source.sweep_fractions.empty()) {
    const Matrix6 H = equations.H() + prediction.weight;
    const Tangent g = equations.g() + prediction.weight * deviation();
    Tangent step = H.ldlt().solve(-g);
    result.T_odom_base = boxplus(result.T_odom_base, step);
    return step;
  }
  const DeskewedStep deskewed =
      deskewedStep(equations, deviation(), prediction.weight, source.mean_fraction, config);
  result.T_odom_base = boxplus(result.T_odom_base, deskewed.step);
  result.deskew_correction = deskewed.correction_per_deviation * deviation();
  return deskewed.step;
}

void stayAt(const Pose& T_odom_predicted, RegistrationResult& result) {
  result.T_odom_base = T_odom_predicted;
  result.deskew_correction = Tangent::Zero();
  result.information = Matrix6::Zero();
  result.sees_motion = false;
  result.outcome = RegistrationOutcome::too_few_correspondences;
}

}  // namespace

RegistrationResult Registration::align(const Points& points_base,
                                       const std::vector<float>& sweep_fractions,
                                       const LocalVoxelMap& map, const PosePrediction& predicted,
                                       double initial_sigma, const RingSpacing& rings) {
  RegistrationResult result;
  result.T_odom_base = predicted.T_odom_base;
  if (map.empty()) return result;
  across_.clear();
  for (const Eigen::Vector3f& point : points_base)
    across_.push_back(rings.at(point.cast<double>(), map.pointSpacing()));
  const Source source{points_base, sweep_fractions, across_, mean(sweep_fractions)};
  RingLimit limit(predicted.motion_is_seen);
  AnnealedSigma sigma(initial_sigma, config_);
  matches_.assign(points_base.size(), CachedMatch{});
  result.outcome = RegistrationOutcome::max_iterations;
  while (result.iterations < config_.max_iterations) {
    const SweepPose pose(result.T_odom_base, result.deskew_correction);
    const ScanObjective objective(config_, sigma.value(), limit.factor());
    const NormalEquations equations = linearise(source, map, pose, objective, matches_);
    result.correspondences = equations.matches();
    if (equations.matches() < static_cast<std::size_t>(config_.min_correspondences)) {
      result.outcome = RegistrationOutcome::converged;
      if (!sigma.isReduced()) stayAt(predicted.T_odom_base, result);
      break;
    }
    result.rms_residual = equations.rms();
    result.explained = shareExplained(equations, points_base.size(), kWeightOfAlike);
    result.explained_anywhere = shareExplained(equations, points_base.size(), 1.0);
    result.information = equations.H() / kMatchVariance;
    limit.update(equations);
    result.sees_motion = !limit.isNeeded();
    const WeighedPrediction prediction =
        weighed(predicted, !sweep_fractions.empty(), limit, config_);
    const Tangent step = takeStep(equations, source, prediction, config_, result);
    ++result.iterations;
    if (!step.allFinite()) {
      stayAt(predicted.T_odom_base, result);
      break;
    }
    if (sigma.hasConverged(step.norm())) {
      result.outcome = RegistrationOutcome::converged;
      break;
    }
  }
  return result;
}

}  // namespace revisit_slam
