// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "revisit_slam/evaluation/consistency_builder.h"
#include "revisit_slam/evaluation/evaluation.h"
#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Points of a scan in the base frame at its stamp. The motion within the scan is taken out as the
/// estimate has it, constant from the first point to the last. Nothing where the estimate has no
/// pose. `config`: range, and whether to deskew.
std::optional<Points> pointsAlong(const PoseInterpolator& estimate, const Scan& scan,
                                  const OdometryConfig& config);

/// Judges one estimate; scans are handed in one after the other, in order of time.
class EstimateJudge {
 public:
  /// Without a reference revisits are those of the estimate itself.
  /// @throws std::runtime_error where fewer than three poses can be compared with the reference.
  EstimateJudge(std::string name, PoseInterpolator estimate,
                const std::optional<PoseInterpolator>& reference, const ConsistencyConfig& config);

  void insert(const Scan& scan, const OdometryConfig& config);
  /// To be called once, after the last scan.
  void compareMaps() { evaluation_.consistency = builder_.finish(); }

  const EstimateEvaluation& evaluation() const { return evaluation_; }

 private:
  PoseInterpolator estimate_;
  ConsistencyBuilder builder_;
  EstimateEvaluation evaluation_;
};

}  // namespace revisit_slam
