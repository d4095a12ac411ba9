// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "revisit_slam/information/motion_covariance.h"
#include "revisit_slam/localization/localization_config.h"
#include "revisit_slam/localization/localization_state.h"
#include "revisit_slam/localization/map_matcher.h"
#include "revisit_slam/localization/place_search.h"
#include "revisit_slam/localization/pose_window.h"
#include "revisit_slam/localization/recent_map.h"
#include "revisit_slam/loops/search/loops_config.h"
#include "revisit_slam/types/informed_scan.h"

namespace revisit_slam {

/// What a localizer takes over of the other stages' parameters.
struct LocalizerConfig {
  LocalizationConfig localization;
  LoopsConfig loops;
  InformationConfig information;
  BackEndConfig backend;
  double submap_voxel_size = 0.5;  ///< m
  MapScale scale;
};

/// Follows a drive through the map of an earlier session. The last metres are registered to the map
/// every few metres, and a graph of the last odometry edges and these registrations gives
/// T_map_odom. A place that is recognised is believed when a second recognition agrees, after a way
/// that the odometry tells, and none agrees on another place. What it says depends on the order of
/// calls alone. All its work runs in the current TBB arena.
class Localizer {
 public:
  Localizer(const LocalizerConfig& config, PriorMapPtr map);

  /// The next scan; one of another session begins where the one before ended.
  Localization add(const InformedScan& informed);

  /// The newest scan, or else the first, is there: believed when one registration confirms it.
  void startAt(const Pose& T_map_base);

 private:
  /// A place for the odometry frame that a registration has confirmed.
  struct Hypothesis {
    Pose T_map_odom;
    double travelled;  // m, when it came up
  };

  void beginTrack();
  void beginSession(const InformedScan& informed);
  void go(const InformedScan& informed);
  Matrix6 guessCovariance() const;
  void attempt();
  void track();
  void searchPlaces();
  bool tryStart();
  void tryPlaces(const SubmapPtr& open, const std::vector<Pose>& T_map_base);
  Pose odomOf(const MapMatch& match) const;
  void guessAt(const Pose& T_map_odom);
  bool agreesWithAny(const Pose& T_map_odom) const;
  bool agrees(const Hypothesis& hypothesis, const Pose& T_map_odom) const;
  bool areNear(const Pose& T_map_odom, const Pose& T_other_odom, double apart) const;
  double patience() const;
  void forgetOldGuesses();
  void believe(const MapMatch& match);
  void note(const MapMatch& match);
  bool isDue(double& last, double interval) const;
  SubmapPtr openSubmap() const;

  LocalizerConfig config_;
  PriorMapPtr map_;
  MapMatcher matcher_;
  PlaceSearch places_;

  RecentMap recent_;
  PoseWindow window_;
  std::optional<Pose> start_;  // T_map_odom that was given; not confirmed yet
  std::vector<Hypothesis> hypotheses_;
  Localization now_;
  Pose T_odom_base_;
  PoseCovariance covariance_;
  bool has_scans_ = false;
  int scans_ = 0;                                                   // of the session
  double attempted_at_ = 0.0, searched_at_ = 0.0, fixed_at_ = 0.0;  // m, travelled
  double started_at_ = 0.0;                                         // likewise: start_ was given
};

}  // namespace revisit_slam
