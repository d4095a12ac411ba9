// SPDX-License-Identifier: MIT
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <map>
#include <mutex>
#include <vector>

#include "revisit_slam/slam/verdict_notice.h"

namespace revisit_slam {

/// Tells users how far the poses can be trusted: as a latched topic, in the log and in the
/// diagnostics. Thread-safe.
class VerdictReport {
 public:
  /// Advertises `pose_verdict`.
  explicit VerdictReport(ros::NodeHandle& node);

  void take(const InformedScan& informed);

  /// Level and message by the last verdict, and whether the information falls behind; how many
  /// scans there were of each kind, and the weak directions of the last.
  void diagnose(diagnostic_msgs::DiagnosticStatus& status);

 private:
  void judge(diagnostic_msgs::DiagnosticStatus& status);

  ros::Publisher publisher_;
  std::mutex mutex_;
  VerdictNotice notice_;
  std::map<PoseVerdict, std::size_t> poses_;
  std::map<InformationSource, std::size_t> scans_;
  std::size_t reported_repeats_ = 0;
  PoseVerdict last_ = PoseVerdict::good;
  std::vector<WeakDirection> weak_directions_;
};

}  // namespace revisit_slam
