// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/types/pose_verdict.h"

namespace revisit_slam {

/// Judges whether a scan fits the map by the share of its points that the map explains. How large
/// that is depends on sensor, speed and surroundings; so it is compared with that of the scans
/// before, and with how much that varied. ICP alone does not tell: it converges in wrong places
/// too.
class FitJudge {
 public:
  explicit FitJudge(const FitConfig& config) : config_(config) {}

  /// Good, poor or lost. `explained`: RegistrationResult::explained of `points` points. `jump`:
  /// RegisteredScan::jump.
  PoseVerdict judge(double explained, std::size_t points, double jump = 0.0) const;

  /// Whether the map explains the share of it that it explains of others.
  bool isUsual(double explained) const;

  /// Takes a scan that entered the map into what is usual.
  void observe(double explained, PoseVerdict verdict);

  /// Whether scans enough have been seen for one to be usual.
  bool isSettled() const;

  /// What the map explains of a scan of late, 0 … 1.
  double usual() const { return usual_; }

 private:
  double leastOfGood() const;

  FitConfig config_;
  std::uint32_t scans_ = 0;
  double usual_ = 0.0;
  double deviation_ = 0.0;  // mean distance from it
};

}  // namespace revisit_slam
