// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/verdict_report.h"

#include <ros/console.h>
#include <std_msgs/String.h>

#include <string>

#include "revisit_slam/ros/messages/scan_messages.h"

namespace revisit_slam {

VerdictReport::VerdictReport(ros::NodeHandle& node)
    : publisher_(node.advertise<std_msgs::String>("pose_verdict", 1, true)) {}

void VerdictReport::take(const InformedScan& informed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string notice = notice_.take(informed);
  if (!notice.empty()) ROS_WARN("%s", notice.c_str());
  if (poses_.empty() || informed.verdict != last_) {
    std_msgs::String message;
    message.data = toString(informed.verdict);
    publisher_.publish(message);
  }
  last_ = informed.verdict;
  ++poses_[last_];
  ++scans_[informed.source];
  weak_directions_ = informed.estimate.weak_directions;
}

void VerdictReport::diagnose(diagnostic_msgs::DiagnosticStatus& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  judge(status);
  for (const auto& [source, count] : scans_)
    addValue(std::string("scans ") + toString(source), std::to_string(count), status);
  for (const auto& [verdict, count] : poses_)
    addValue(std::string("poses ") + toString(verdict), std::to_string(count), status);
  addWeakDirections(weak_directions_, status);
}

void VerdictReport::judge(diagnostic_msgs::DiagnosticStatus& status) {
  const std::size_t repeated = scans_[InformationSource::repeated];
  const bool falls_behind = repeated > reported_repeats_;
  reported_repeats_ = repeated;
  const bool is_bad = last_ >= PoseVerdict::poor;
  const bool is_weak = !weak_directions_.empty();
  status.level = last_ == PoseVerdict::lost          ? status.ERROR
                 : is_bad || is_weak || falls_behind ? status.WARN
                                                     : status.OK;
  status.message = is_bad ? std::string("pose ") + toString(last_)
                   : falls_behind
                       ? "falling behind: the information of a scan is repeated; give it more "
                         "threads (odometry/threads)"
                   : is_weak ? "weak directions"
                             : "running";
}

}  // namespace revisit_slam
