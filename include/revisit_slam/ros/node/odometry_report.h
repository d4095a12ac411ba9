// SPDX-License-Identifier: MIT
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>

#include "revisit_slam/slam/odometry_stage.h"
#include "revisit_slam/util/recent_times.h"

namespace revisit_slam {

/// The numbers of the odometry in the diagnostics. For one thread at a time.
class OdometryReport {
 public:
  /// A scan was registered just now.
  void note(const RegisteredScan& scan);
  /// It took so long.
  void noteTime(double milliseconds) { times_.add(milliseconds); }
  void restart() { times_ = {}; }

  double medianTime() const { return times_.median(); }  ///< ms
  void tell(const OdometryStage& stage, diagnostic_msgs::DiagnosticStatus& status) const;

 private:
  RegistrationResult last_;
  double delay_ = 0.0;  // s
  RecentTimes times_;
};

}  // namespace revisit_slam
