// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include <optional>

#include "revisit_slam/information/information_config.h"
#include "revisit_slam/information/information_estimator.h"
#include "revisit_slam/information/motion_covariance.h"
#include "revisit_slam/slam/odometry_stage.h"
#include "revisit_slam/types/informed_scan.h"

namespace revisit_slam {

/// Gives each registered scan the information of its edge, and the covariances of its motion and
/// pose, and a verdict on it. No scan is left out: with too many waiting the information of the
/// scan before is repeated. The first scan of a session begins anew.
class InformationStage {
 public:
  explicit InformationStage(const InformationConfig& config);

  /// `waiting`: scans that wait behind this one.
  InformedScan inform(const OdometryOutput& odometry, std::size_t waiting = 0);

  void reconfigure(const InformationConfig& config);

 private:
  void startSession(SessionId session);
  void estimate(const RegistrationProblem& problem, InformedScan& informed);
  void doubt(InformedScan& informed) const;
  void growCovariance(InformedScan& informed, bool begins);

  InformationConfig config_;
  InformationEstimator estimator_;
  tbb::task_arena arena_{1};  // the work of a scan is smaller than handing it to others

  std::optional<SessionId> session_;
  // Of it.
  MotionCovariance motion_covariance_;
  PoseCovariance pose_covariance_;
  InformationEstimate last_estimate_;
  Pose T_odom_previous_;
};

}  // namespace revisit_slam
