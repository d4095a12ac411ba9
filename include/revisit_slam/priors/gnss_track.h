// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/priors/gnss_config.h"
#include "revisit_slam/priors/gnss_reading.h"
#include "revisit_slam/priors/prior_account.h"
#include "revisit_slam/types/gnss_fix.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// Ties positions of GNSS to scans, along the odometry. A position takes part with the first scan
/// that is max_delay later than it: which scan that is depends on stamps alone, so that live and
/// offline agree, and no scan waits for it.
class GnssTrack {
 public:
  explicit GnssTrack(const GnssConfig& config) : config_(config) {}

  static constexpr const char* kSensor = "gnss";

  bool isConnected() const { return config_.isConnected(); }

  void take(GnssReading reading);
  /// Of a message that never became a reading.
  void countDropped(const std::string& reason);

  /// A scan was registered; scans of a base that rests repeat an id. Stamps go on.
  void observe(ScanId id, Stamp stamp, const Pose& T_odom_base);
  /// The positions that are due with the newest scan, in order of their stamps, once each.
  std::vector<GnssFix> due();

  const PriorAccount& account() const { return account_; }

  /// Another session, in an odometry frame of its own.
  void restart();

 private:
  struct Placed {
    ScanId id;
    Stamp stamp;
    Pose T_odom_base;
    Pose T_odom_first;  ///< at the first scan of this id
  };

  std::optional<GnssFix> tie(const GnssReading& reading);
  void drop(const std::string& reason) { ++account_.dropped[reason]; }

  GnssConfig config_;
  std::deque<GnssReading> waiting_;  // in order of stamps
  std::deque<Placed> scans_;
  std::optional<Eigen::Vector3d> last_odom_;  // the antenna at the last position that was tied
  double last_variance_ = 0.0;                // of that position, sum over the axes, m^2
  bool was_heard_ = false;                    // since the last scan
  std::optional<Stamp> heard_at_;  // the scan by which there was a position, or the first
  PriorAccount account_;
};

}  // namespace revisit_slam
