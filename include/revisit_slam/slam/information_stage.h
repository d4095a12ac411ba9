// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include "revisit_slam/types/informed_scan.h"
#include "revisit_slam/information/information_config.h"
#include "revisit_slam/information/information_estimator.h"
#include "revisit_slam/information/motion_covariance.h"

namespace revisit_slam {

/// Gives each registered scan the information of its edge. Keeps the last estimate for scans that
/// there is no time to estimate.
class InformationStage {
 public:
  explicit InformationStage(const InformationConfig& config);

  InformedScan inform(std::shared_ptr<const RegisteredScan> scan);

  /// Without estimating: repeats the information of the scan before.
  InformedScan repeat(std::shared_ptr<const RegisteredScan> scan);

  void reconfigure(const InformationConfig& config);

 private:
  InformationEstimator estimator_;
  tbb::task_arena arena_{1};  // the work of a scan is smaller than handing it to others
  MotionCovariance covariance_;
  InformationEstimate last_estimate_;
};

}  // namespace revisit_slam
