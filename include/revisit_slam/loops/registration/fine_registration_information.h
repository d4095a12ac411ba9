// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

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

  /// For right perturbations of the source frame; the identity where it is switched off. Runs in
  /// the current TBB arena. The next call with the same target takes half as long. For one thread.
  InformationEstimate estimate(const Submap& source, const SubmapPtr& target,
                               const Pose& T_target_source) const;

 private:
  /// A target made ready.
  struct Target {
    SubmapPtr submap;
    double scale;
    LocalVoxelMap map;
  };
  const LocalVoxelMap& prepared(const SubmapPtr& target, double scale) const;

  FineRegistrationConfig config_;
  bool enabled_;
  InformationEstimator estimator_;
  mutable std::shared_ptr<const Target> last_;
};

}  // namespace revisit_slam
