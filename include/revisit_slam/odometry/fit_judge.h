// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/types/pose_verdict.h"

namespace revisit_slam {

/// How a scan fits the map: RegistrationResult::explained, explained_anywhere.
struct Fit {
  double explained = 0.0;
  double anywhere = 0.0;
};

/// Judges whether a scan fits the map by the share of its points that the map explains. How large
/// that is depends on sensor, speed and surroundings; so it is compared with that of the scans
/// before, and with how much that varied. ICP alone does not tell: it converges in wrong places
/// too.
class FitJudge {
 public:
  explicit FitJudge(const FitConfig& config) : config_(config) {}

  /// Good, poor or lost, of a scan of `points` points. `jump`: RegisteredScan::jump.
  PoseVerdict judge(const Fit& fit, std::size_t points, double jump = 0.0) const;

  /// Whether of all points alike the map explains the share that it explains of others.
  bool isUsual(double anywhere) const;

  /// Whether the pose is farther from the prediction than can be expected.
  bool hasJumped(double jump) const { return config_.jump > 0.0 && jump > config_.jump; }

  /// Whether a poor scan was seen through so much of the map, as shareSeenThrough() has it of this
  /// scan and the one before, that its pose cannot be right.
  bool isContradicted(double through, double before) const {
    return config_.through > 0.0 && isSettled() && through > 2.0 * before + config_.through;
  }

  /// Takes a scan that entered the map into what is usual.
  void observe(const Fit& fit, PoseVerdict verdict);

  /// Whether scans enough have been seen for one to be usual.
  bool isSettled() const;

  /// What the map explains of a scan of late, 0 … 1.
  double usual() const { return usual_.explained; }

 private:
  double leastOfGood() const;

  FitConfig config_;
  std::uint32_t scans_ = 0;
  Fit usual_;
  double deviation_ = 0.0;  // mean distance from it
};

}  // namespace revisit_slam
