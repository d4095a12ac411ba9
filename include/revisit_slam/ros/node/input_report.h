// SPDX-License-Identifier: MIT
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <exception>
#include <mutex>
#include <string>
#include <vector>

#include "revisit_slam/ros/node/input_watch.h"
#include "revisit_slam/ros/node/scan_subscription.h"
#include "revisit_slam/slam/odometry_stage.h"
#include "revisit_slam/util/lane.h"

namespace revisit_slam {

/// Tells users, in the log and in the diagnostics, what the odometry receives, what is wrong with
/// it and what to do. For one thread at a time, but for askMaster().
class InputReport {
 public:
  /// Where point times come from, and what to do where there are none; logged when that changes.
  void noteTimes(const std::string& description, const std::string& remedy);

  /// Where nothing has come since the last time, what is published: in a thread of its own, as a
  /// master that cannot be reached answers late or never.
  void askMaster(const ScanSubscription& scans);
  /// Level and message of what is most wrong, and the numbers behind it.
  void tell(const ScanSubscription& scans, std::size_t waiting, const std::string& transform_fault,
            double milliseconds_a_scan, const OdometryStage& stage,
            diagnostic_msgs::DiagnosticStatus& status);

 private:
  std::string timeFault(const OdometryStage& stage) const;

  InputWatch watch_;
  std::string times_, remedy_;
  std::size_t arrived_before_ = 0;
  std::mutex mutex_;  // guards the next one
  std::vector<TypedTopic> published_;
  ThreadLane asking_{0, [](std::exception_ptr) {}};  // who gets no answer asks again
};

}  // namespace revisit_slam
