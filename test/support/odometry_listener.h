// SPDX-License-Identifier: MIT
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>

#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {

/// Whether the condition became true before the patience of a test on a busy machine ended.
template <typename Condition>
bool becomesTrue(const Condition& condition, double seconds = 30.0) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (!condition()) {
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

/// What an odometry nodelet tells the world.
class OdometryListener {
 public:
  /// `space`: namespace of the nodelet, with a slash at its end.
  explicit OdometryListener(const std::string& space = "/")
      : status_name_(space + "odometry: odometry") {
    odometry_subscriber_ =
        node_.subscribe(space + "odometry_raw", 1000, &OdometryListener::onOdometry, this);
    diagnostics_subscriber_ =
        node_.subscribe("/diagnostics", 1000, &OdometryListener::onDiagnostics, this);
  }
  ~OdometryListener() {
    odometry_subscriber_.shutdown();
    diagnostics_subscriber_.shutdown();
  }

  bool isConnected() const { return odometry_subscriber_.getNumPublishers() > 0; }

  Trajectory trajectory() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return trajectory_;
  }
  std::vector<Stamp> stamps() const {
    std::vector<Stamp> stamps;
    for (const StampedPose& pose : trajectory()) stamps.push_back(pose.stamp);
    return stamps;
  }
  bool hasPoses(std::size_t count) const {
    return becomesTrue([&] { return trajectory().size() >= count; });
  }

  /// A number of the latest diagnostics, 0 where it is missing.
  int diagnosed(const std::string& key) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto entry = diagnostics_.find(key);
    return entry == diagnostics_.end() ? 0 : std::stoi(entry->second);
  }
  bool diagnoses(const std::string& key, int value) const {
    return becomesTrue([&] { return diagnosed(key) == value; });
  }
  bool diagnosesEndingWith(const std::string& key, const std::string& end) const {
    return becomesTrue([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto entry = diagnostics_.find(key);
      if (entry == diagnostics_.end() || entry->second.size() < end.size()) return false;
      return entry->second.compare(entry->second.size() - end.size(), end.size(), end) == 0;
    });
  }
  /// Of the latest diagnostics.
  int level() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return level_;
  }
  std::string message() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return message_;
  }
  /// Whether the diagnostics came to be of this level, with this in their message.
  bool judges(int level, const std::string& text) const {
    return becomesTrue([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return level_ == level && message_.find(text) != std::string::npos;
    });
  }
  /// Scans dropped, by reason.
  std::map<std::string, int> drops() const {
    const std::string prefix = "scans dropped, ";
    const std::lock_guard<std::mutex> lock(mutex_);
    std::map<std::string, int> drops;
    for (const auto& [key, value] : diagnostics_)
      if (key.rfind(prefix, 0) == 0) drops[key.substr(prefix.size())] = std::stoi(value);
    return drops;
  }

 private:
  void onOdometry(const nav_msgs::Odometry& odometry) {
    const auto& [p, q] = odometry.pose.pose;
    const std::lock_guard<std::mutex> lock(mutex_);
    trajectory_.push_back(
        {toStamp(odometry.header.stamp), {{q.w, q.x, q.y, q.z}, {p.x, p.y, p.z}}});
  }
  void onDiagnostics(const diagnostic_msgs::DiagnosticArray& array) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& status : array.status) {
      if (status.name != status_name_) continue;
      level_ = status.level;
      message_ = status.message;
      diagnostics_.clear();
      for (const auto& [key, value] : status.values) diagnostics_[key] = value;
    }
  }

  ros::NodeHandle node_;
  std::string status_name_;
  ros::Subscriber odometry_subscriber_, diagnostics_subscriber_;
  mutable std::mutex mutex_;  // guards the next four
  Trajectory trajectory_;
  int level_ = -1;
  std::string message_;
  std::map<std::string, std::string> diagnostics_;
};

}  // namespace revisit_slam
