// SPDX-License-Identifier: MIT
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <nodelet/nodelet.h>
#include <ros/node_handle.h>

#include <string>

#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// What all nodelets have in common: they read their parameters, start, and say how they are.
class SlamNodelet : public nodelet::Nodelet {
 protected:
  /// `part`: what the diagnostics are about.
  explicit SlamNodelet(const std::string& part) : part_(part) {}

  /// With the parameters read and checked.
  virtual void start() = 0;
  /// In a thread of the node.
  virtual void diagnose(diagnostic_msgs::DiagnosticStatus& status) = 0;
  /// First thing in destructors: nothing may call into an object while its parts go.
  void stopDiagnostics() { diagnostics_timer_.stop(); }

  SlamConfig config_;

 private:
  void onInit() override;
  void publishDiagnostics();

  const std::string part_;
  ros::Publisher diagnostics_publisher_;
  ros::WallTimer diagnostics_timer_;
};

}  // namespace revisit_slam
