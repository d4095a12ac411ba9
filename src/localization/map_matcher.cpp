// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/map_matcher.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

namespace revisit_slam {
namespace {

/// Travelled distances of different drives do not compare, and what a short open submap shares with
/// another is for the gates to say.
LoopCloserConfig acrossDrives(LoopCloserConfig config, double min_overlap) {
  config.min_fitness = min_overlap;
  config.association.min_overlap = 0.0;
  config.association.min_detour = 0.0;
  return config;
}

/// A guess within decimetres needs no coarse levels, which take most of the time.
LoopCloserConfig withoutCoarseLevels(LoopCloserConfig config) {
  FineRegistrationConfig& registration = config.registration;
  registration.coarsest_distance =
      std::min(registration.coarsest_distance, 2.0 * registration.finest_distance);
  return config;
}

/// Along any axis.
double largestDeviation(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues().maxCoeff()));
}

/// From one pose to another.
struct Moved {
  Moved(const Pose& from, const Pose& to) {
    const Pose T_from_to = from.inverse() * to;
    metres = T_from_to.translation.norm();
    degrees = T_from_to.angle() * 180.0 / M_PI;
  }

  bool isWithin(const MapMatcher::Reach& most) const {
    return metres <= most.metres && degrees <= most.degrees;
  }

  double metres, degrees;
};

void reject(const std::string& reason, MapMatch& match) {
  match.accepted = false;
  match.reason = reason;
}

}  // namespace

MapMatcher::MapMatcher(PriorMapPtr map, LoopCloserConfig closer,
                       const InformationConfig& information, double min_overlap)
    : map_(std::move(map)),
      config_(acrossDrives(std::move(closer), min_overlap)),
      coarse_to_fine_(config_, information),
      fine_(withoutCoarseLevels(config_), information),
      tracking_(withoutCoarseLevels(config_), information) {}

/// Without points.
std::vector<PlacedSubmap> MapMatcher::near(const Eigen::Vector3d& position) const {
  std::vector<PlacedSubmap> near;
  for (const PlacedSubmap& placed : map_->submaps) {
    const Eigen::Vector3d p = placed.T_common_submap.inverse() * position;
    const auto& way = placed.submap->T_submap_scan;
    if (std::any_of(way.begin(), way.end(), [&](const Pose& T_submap_scan) {
          return (T_submap_scan.translation - p).norm() <= config_.association.max_gap;
        }))
      near.push_back(placed);
  }
  return near;
}

/// Those that can be read. @throws std::runtime_error where that is none of them.
std::vector<PlacedSubmap> MapMatcher::whole(const std::vector<PlacedSubmap>& submaps) const {
  std::vector<PlacedSubmap> whole;
  std::exception_ptr error;
  for (const PlacedSubmap& placed : submaps) {
    try {
      whole.push_back(map_->whole(placed));
    } catch (const std::runtime_error&) {
      error = std::current_exception();
    }
  }
  if (whole.empty() && error) std::rethrow_exception(error);
  return whole;
}

MapMatch MapMatcher::match(const LoopCloser& closer, const SubmapPtr& open, const Pose& T_map_open,
                           const std::vector<PlacedSubmap>& near) const {
  MapMatch match;
  std::vector<PlacedSubmap> targets;
  try {
    targets = whole(near);
  } catch (const std::runtime_error& error) {  // the folder of the map is gone
    match.reason = error.what();
    return match;
  }
  const std::vector<LoopProposal> proposals =
      closer.close({{open, T_map_open}}, targets, LoopOrigin::appearance);
  if (proposals.empty()) {
    match.reason = "off the map";
    return match;
  }
  const LoopProposal& proposal = proposals.front();
  const FineRegistrationResult& registration = proposal.registered.registration;
  match.accepted = proposal.verdict.isAccepted();
  match.reason = proposal.verdict.reason();
  match.target = proposal.loop.target;
  match.registered = registration.outcome != FineRegistrationOutcome::too_few_correspondences;
  match.T_map_open = proposal.registered.T_common_target * registration.T_target_source;
  match.information = proposal.loop.constraint.information;
  match.mean_squared_residual = proposal.mean_squared_residual;
  match.overlap = registration.fitness;
  match.coherence = registration.coherence;
  return match;
}

/// Rivals that the odometry rules out are not looked for: that takes as long as the registration.
MapMatch MapMatcher::track(const SubmapPtr& open, const Pose& T_map_open, double travelled,
                           const Matrix6& covariance) {
  const PairwiseConsistencyConfig& limits = config_.consistency;
  Reach reach{limits.reach(travelled), limits.rotation + limits.rotation_drift * travelled};
  reach.metres = std::max(reach.metres, 3.0 * largestDeviation(covariance.topLeftCorner<3, 3>()));
  reach.degrees = std::max(
      reach.degrees, 3.0 * 180.0 / M_PI * largestDeviation(covariance.bottomRightCorner<3, 3>()));
  LoopCloserConfig config = withoutCoarseLevels(config_);
  // Which the loop closer makes smaller where the surroundings are narrow.
  const std::vector<PlacedSubmap> near = this->near(T_map_open.translation);
  const double scale = scaleOf({{open, T_map_open}}, near);
  config.max_translation = std::min(config.max_translation, reach.metres / scale);
  tracking_.reconfigure(config);
  return follow(tracking_, open, T_map_open, near, reach);
}

MapMatch MapMatcher::follow(const LoopCloser& closer, const SubmapPtr& open, const Pose& T_map_open,
                            const std::vector<PlacedSubmap>& near, const Reach& reach) const {
  MapMatch match = this->match(closer, open, T_map_open, near);
  if (match.accepted && !Moved(T_map_open, match.T_map_open).isWithin(reach))
    reject("the registration contradicts the odometry", match);
  return match;
}

MapMatch MapMatcher::relocate(const SubmapPtr& open, const Pose& T_map_open) const {
  MapMatch first = match(coarse_to_fine_, open, T_map_open, near(T_map_open.translation));
  if (!first.registered) return first;
  const PairwiseConsistencyConfig& limits = config_.consistency;
  MapMatch match = follow(fine_, open, first.T_map_open, near(first.T_map_open.translation),
                          {limits.reach(0.0), limits.rotation});
  if (match.accepted && !Moved(T_map_open, match.T_map_open)
                             .isWithin({config_.max_translation, config_.max_rotation}))
    reject("the registration left the guess", match);
  return match;
}

}  // namespace revisit_slam
