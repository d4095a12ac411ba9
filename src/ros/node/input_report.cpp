// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/input_report.h"

#include <ros/console.h>
#include <ros/time.h>

#include <utility>

#include "revisit_slam/ros/messages/scan_messages.h"

namespace revisit_slam {
namespace {

using Level = InputWatch::Level;

using Status = diagnostic_msgs::DiagnosticStatus;

Status::_level_type levelOf(Level level) {
  return level == Level::ok ? Status::OK : level == Level::warn ? Status::WARN : Status::ERROR;
}

void log(const InputWatch::Verdict& verdict) {
  if (verdict.level == Level::ok) ROS_INFO("%s", verdict.sentence.c_str());
  if (verdict.level == Level::warn) ROS_WARN("%s", verdict.sentence.c_str());
  if (verdict.level == Level::error) ROS_ERROR("%s", verdict.sentence.c_str());
}

}  // namespace

void InputReport::noteTimes(const std::string& description, const std::string& remedy) {
  remedy_ = remedy;
  if (description == times_) return;
  times_ = description;
  if (remedy.empty())
    ROS_INFO("%s", times_.c_str());
  else
    ROS_WARN("%s; %s", times_.c_str(), remedy_.c_str());
}

void InputReport::askMaster(const ScanSubscription& scans) {
  const std::size_t arrived = scans.arrived();
  if (std::exchange(arrived_before_, arrived) != arrived || asking_.waiting() > 0) return;
  asking_.post([this] {
    std::vector<TypedTopic> topics = publishedTopics();
    const std::lock_guard<std::mutex> lock(mutex_);
    published_ = std::move(topics);
  });
}

void InputReport::tell(const ScanSubscription& scans, std::size_t waiting,
                       const std::string& transform_fault, double milliseconds_a_scan,
                       const OdometryStage& stage, diagnostic_msgs::DiagnosticStatus& status) {
  InputState state;
  state.now = ros::WallTime::now().toSec();
  state.topics = scans.topics();
  state.several_sensors = scans.areOfSeveral();
  state.arrived = scans.arrived();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    state.published = published_;
  }
  state.waiting = waiting;
  state.clock_runs = !ros::Time::now().isZero();
  state.transform_fault = transform_fault;
  state.scan_seconds = 1e-3 * milliseconds_a_scan;
  state.account = stage.account();
  state.time_fault = timeFault(stage);
  const InputWatch::Verdict verdict = watch_.look(state);
  if (verdict.is_new) log(verdict);
  status.level = levelOf(verdict.level);
  status.message = verdict.sentence;
  addValue("point times", times_, status);
}

std::string InputReport::timeFault(const OdometryStage& stage) const {
  if (!remedy_.empty()) return times_ + "; " + remedy_;
  return stage.doubtsTimes() ? stage.sweepForm() : "";
}

}  // namespace revisit_slam
