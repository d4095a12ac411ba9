// SPDX-License-Identifier: MIT
#include "slam_nodelet.h"

#include <diagnostic_msgs/DiagnosticArray.h>

#include "revisit_slam/ros/node/parameter_server.h"

namespace revisit_slam {

void SlamNodelet::onInit() {
  try {
    config_ = loadConfig<SlamConfig>(getPrivateNodeHandle());
  } catch (const ParameterError& error) {
    NODELET_FATAL("%s", error.what());  // the loader drops what is thrown
    throw;
  }
  start();
  ros::NodeHandle& node = getNodeHandle();
  diagnostics_publisher_ = node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10);
  diagnostics_timer_ = node.createWallTimer(ros::WallDuration(config_.live.diagnostics_period),
                                            [this](const auto&) { publishDiagnostics(); });
}

void SlamNodelet::publishDiagnostics() {
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  array.status.resize(1);
  array.status[0].name = getName() + ": " + part_;
  diagnose(array.status[0]);
  diagnostics_publisher_.publish(array);
}

}  // namespace revisit_slam
