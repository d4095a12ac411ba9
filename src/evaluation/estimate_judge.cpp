// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/estimate_judge.h"

#include <algorithm>
#include <utility>

#include "revisit_slam/odometry/motion.h"
#include "revisit_slam/odometry/preprocessing.h"

namespace revisit_slam {

std::optional<Points> pointsAlong(const PoseInterpolator& estimate, const Scan& scan,
                                  const OdometryConfig& config) {
  const PoseAnswer end = estimate.at(scan.stamp);
  if (!end) return std::nullopt;
  ConstantMotion motion;
  if (config.deskew && !scan.times.empty()) {
    const double span = -*std::min_element(scan.times.begin(), scan.times.end());
    const PoseAnswer start = estimate.at(scan.stamp.plusSeconds(-span));
    if (!start) return std::nullopt;
    if (span > 0.0)
      motion = ConstantMotion(log(start.T_world_base.inverse() * end.T_world_base) / span);
  }
  return preprocess(scan, motion, config).points_base;
}

EstimateJudge::EstimateJudge(std::string name, PoseInterpolator estimate,
                             const std::optional<PoseInterpolator>& reference,
                             const ConsistencyConfig& config)
    : estimate_(std::move(estimate)),
      builder_(findRevisits((reference ? *reference : estimate_).poses(), config), config) {
  evaluation_.name = std::move(name);
  evaluation_.estimate = estimate_.poses();
  if (reference) evaluation_.trajectory = evaluateTrajectory(estimate_, *reference);
}

void EstimateJudge::insert(const Scan& scan, const OdometryConfig& config) {
  if (!builder_.wants(scan.stamp)) return;
  const std::optional<Points> points = pointsAlong(estimate_, scan, config);
  ++(points ? evaluation_.scans_used : evaluation_.scans_without_pose);
  if (points) builder_.insert(scan.stamp, *points, estimate_.at(scan.stamp).T_world_base);
}

}  // namespace revisit_slam
