// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/slam_nodelet.h"

#include <diagnostic_msgs/DiagnosticArray.h>

#include <cmath>
#include <exception>
#include <utility>

#include "revisit_slam/ros/messages/scan_messages.h"
#include "revisit_slam/ros/node/parameter_server.h"
#include "revisit_slam/util/process_usage.h"

namespace revisit_slam {

void SlamNodelet::onInit() {
  try {
    config_ = loadConfig<SlamConfig>(getPrivateNodeHandle());
    config_.frames.dropLeadingSlashes();
    start();
    watchLoad("CPU of the process", processCpuSeconds);
  } catch (const std::exception& error) {
    NODELET_FATAL("%s", error.what());  // the loader drops what is thrown
    throw;
  }
  ros::NodeHandle& node = getNodeHandle();
  diagnostics_publisher_ = node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10);
  diagnostics_timer_ =
      node.createWallTimer(ros::WallDuration(config_.live.diagnostics_period),
                           [this](const auto&) { guarded([this] { publishDiagnostics(); }); });
}

std::unique_ptr<ThreadLane> SlamNodelet::makeLane(const std::string& work, int niceness) {
  auto lane = std::make_unique<ThreadLane>(niceness, [this](std::exception_ptr error) {
    guarded([&] { std::rethrow_exception(error); });
  });
  watchLoad("busy with " + work, [lane = lane.get()] { return lane->busySeconds(); });
  return lane;
}

void SlamNodelet::watchLoad(const std::string& work, std::function<double()> busy_seconds) {
  loads_.push_back({work, std::move(busy_seconds), {}});
}

void SlamNodelet::noteError(const std::string& error) {
  NODELET_ERROR("%s", error.c_str());
  const std::lock_guard<std::mutex> lock(errors_mutex_);
  ++errors_;
  untold_error_ = error;
}

void SlamNodelet::publishDiagnostics() {
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  array.status.resize(1);
  array.status[0].name = getName() + ": " + part_;
  diagnose(array.status[0]);
  tellLoads(array.status[0]);
  tellErrors(array.status[0]);
  diagnostics_publisher_.publish(array);
}

void SlamNodelet::tellLoads(diagnostic_msgs::DiagnosticStatus& status) {
  for (Load& load : loads_) {
    const double percent = 100.0 * load.share.look(load.busy_seconds());
    addValue(load.work + " (%)", std::to_string(std::lround(percent)), status);
  }
}

void SlamNodelet::tellErrors(diagnostic_msgs::DiagnosticStatus& status) {
  const std::lock_guard<std::mutex> lock(errors_mutex_);
  addValue("errors", std::to_string(errors_), status);
  if (untold_error_.empty()) return;
  status.level = status.ERROR;
  status.message = untold_error_;
  untold_error_.clear();
}

}  // namespace revisit_slam
