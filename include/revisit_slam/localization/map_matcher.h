// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "revisit_slam/information/information_config.h"
#include "revisit_slam/localization/prior_map.h"
#include "revisit_slam/loops/acceptance/loop_closer.h"

namespace revisit_slam {

/// What became of registering the last metres to the map.
struct MapMatch {
  bool accepted = false;
  std::string reason;              ///< empty if accepted
  std::optional<SubmapId> target;  ///< of the map; none: it is off the map
  Pose T_map_open;                 ///< where the registration ended, if `registered`
  bool registered = false;
  Matrix6 information = Matrix6::Identity();  ///< for right perturbations of T_map_open
  double mean_squared_residual = 0.0;         ///< m^2, of the objective of the information
  double overlap = 0.0;                       ///< 0 … 1, FineRegistrationResult::fitness
  double coherence = 0.0;                     ///< likewise
};

/// Registers an open submap to the submap of the map that sees most of the same, with the gates of
/// a loop whose place something else speaks for. Runs in the current TBB arena.
class MapMatcher {
 public:
  /// How far a registration may end from its guess.
  struct Reach {
    double metres, degrees;
  };

  /// `min_overlap`: LocalizationConfig::min_overlap.
  MapMatcher(PriorMapPtr map, LoopCloserConfig closer, const InformationConfig& information,
             double min_overlap);

  /// From where the odometry has carried the last fix, `travelled` m ago: the registration may
  /// differ by no more than two loops of the same maps may (PairwiseConsistencyConfig), or by
  /// three standard deviations of where it has carried it: the odometry knows if it was lost.
  MapMatch track(const SubmapPtr& open, const Pose& T_map_open, double travelled,
                 const Matrix6& covariance = Matrix6::Zero());
  /// From a guess that is off by metres: where a registration from it ends is the guess of a second
  /// one, which has to stay there.
  MapMatch relocate(const SubmapPtr& open, const Pose& T_map_open) const;

 private:
  // `near`: submaps about T_map_open, without points.
  MapMatch follow(const LoopCloser& closer, const SubmapPtr& open, const Pose& T_map_open,
                  const std::vector<PlacedSubmap>& near, const Reach& reach) const;
  MapMatch match(const LoopCloser& closer, const SubmapPtr& open, const Pose& T_map_open,
                 const std::vector<PlacedSubmap>& near) const;
  std::vector<PlacedSubmap> near(const Eigen::Vector3d& position) const;
  std::vector<PlacedSubmap> whole(const std::vector<PlacedSubmap>& submaps) const;

  PriorMapPtr map_;
  LoopCloserConfig config_;
  // From guesses that are off by metres and by decimetres, and from where the odometry has carried.
  LoopCloser coarse_to_fine_, fine_, tracking_;
};

}  // namespace revisit_slam
