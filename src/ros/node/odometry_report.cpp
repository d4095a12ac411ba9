// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/odometry_report.h"

#include <ros/time.h>

#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/ros/messages/scan_messages.h"

namespace revisit_slam {

void OdometryReport::note(const RegisteredScan& scan) {
  last_ = scan.registration;
  delay_ = secondsBetween(scan.stamp, toStamp(ros::Time::now()));
}

void OdometryReport::tell(const OdometryStage& stage,
                          diagnostic_msgs::DiagnosticStatus& status) const {
  addValue("messages", stage.sweepForm(), status);
  addValue("registration", toString(last_.outcome), status);
  addValue("iterations", std::to_string(last_.iterations), status);
  addValue("delay (s)", std::to_string(delay_), status);
  addValue("time of a scan: median, p99, largest (ms)", times_.summary(), status);
  addValue("scans held until the next", std::to_string(stage.held()), status);
  addAccount(stage.account(), status);
  addPriors(stage.sensorAccounts(), status);
  addLidars(stage.lidarAccounts(), status);
}

}  // namespace revisit_slam
