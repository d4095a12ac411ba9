// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/priors/gravity_config.h"
#include "revisit_slam/priors/motion_reading.h"
#include "revisit_slam/priors/prior_account.h"
#include "revisit_slam/types/gravity_direction.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// Directions of gravity, of the accelerations f of an inertial unit and of the poses that were
/// registered meanwhile. Between three scans at t_0 < t_1 < t_2 the unit at p_odom(t) and with the
/// orientation R_odom_base(t) measures, with weights w that rise linearly from t_0 to t_1, fall to
/// t_2 and have the integral 1,
///
///   int w R_odom_base f dt = 2 / (t_2 - t_0) ((p_2 - p_1) / (t_2 - t_1) - (p_1 - p_0) / (t_1 -
///   t_0)) + g,
///
/// where g points up. No velocity enters: a scan is as good as its position.
class GravityTrack {
 public:
  explicit GravityTrack(const GravityConfig& config) : config_(config) {}

  static constexpr const char* kSensor = "gravity";

  /// In order of stamps; one that is older by a second is of a clock that was set back.
  void take(const ImuReading& reading);

  /// A scan was registered; scans of a base that rests repeat an id. Stamps go on. Readings have to
  /// reach it. @return a direction where the scan ends a window.
  std::optional<GravityDirection> observe(ScanId id, Stamp stamp, const Pose& T_odom_base);

  const PriorAccount& account() const { return account_; }

  /// Another session, in an odometry frame of its own.
  void restart();

 private:
  struct Placed {
    ScanId id;
    Stamp stamp;
    Pose T_odom_base;
    Eigen::Quaterniond R_odom_first;  // of the first scan of this id, which the graph knows
  };

  std::optional<GravityDirection> endWindow();
  std::optional<Eigen::Vector3d> meanForce(std::size_t middle) const;
  Eigen::Quaterniond orientationAt(Stamp stamp) const;
  Eigen::Vector3d acceleration(std::size_t middle) const;
  std::size_t middleScan() const;

  GravityConfig config_;
  std::deque<ImuReading> readings_;  // since the window's begin, in order of stamps
  std::vector<Placed> scans_;        // of the window
  std::optional<Placed> newest_;     // scan, of windows before as well
  std::optional<ScanId> last_;       // that was given a direction
  PriorAccount account_;
};

}  // namespace revisit_slam
