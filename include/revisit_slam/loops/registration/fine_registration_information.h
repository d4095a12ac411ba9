// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/icp/local_voxel_map.h"
#include "revisit_slam/information/information_estimator.h"
#include "revisit_slam/loops/registration/fine_registration_config.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// Lambda_lc (paper Sec. III-C): the objective of point-to-point ICP of the source submap to the
/// target submap, sampled as that of a scan is (Sec. III-B). The source is thinned like a scan of
/// the odometry: neighbouring voxels share their drift, and an edge of either kind weighs alike.
class LoopInformation {
 public:
  LoopInformation(const InformationConfig& information, const FineRegistrationConfig& registration);

  /// For right perturbations of the source frame. Runs in the current TBB arena.
  Matrix6 estimate(const Submap& source, const Submap& target, const Pose& T_target_source) const;

 private:
  FineRegistrationConfig config_;
  bool enabled_;
  InformationEstimator estimator_;
};

}  // namespace revisit_slam
