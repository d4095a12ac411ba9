// SPDX-License-Identifier: MIT
#pragma once

#include <ros/master.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <algorithm>
#include <boost/shared_ptr.hpp>
#include <chrono>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace revisit_slam {

/// Whether somebody advertises all these topics. The number of subscribers does not tell who
/// listens: those of one process count as one.
inline bool areAdvertised(const ros::NodeHandle& node, const std::vector<std::string>& names) {
  ros::master::V_TopicInfo topics;
  ros::master::getTopics(topics);
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    const std::string wanted = node.resolveName(name);
    return std::any_of(topics.begin(), topics.end(),
                       [&](const auto& topic) { return topic.name == wanted; });
  });
}

/// Nodelets are loaded in any order while the sensor runs already: what is published before those
/// that need it listen waits for them, so that they see every scan. Patience ends: whoever is not
/// there after 10 s is not expected any more. Only one thread may use it.
template <typename T>
class PatientPublisher {
 public:
  PatientPublisher() = default;
  PatientPublisher(const ros::Publisher& publisher, std::function<bool()> everybody_listens)
      : publisher_(publisher), everybody_listens_(std::move(everybody_listens)) {}

  void publish(const boost::shared_ptr<const T>& message) {
    if (waiting_.empty() && !open_) first_ = Clock::now();
    waiting_.push_back(message);
    if (!open_) open_ = everybody_listens_() || Clock::now() - first_ > kPatience;
    if (!open_) return;
    for (const auto& due : waiting_) publisher_.publish(due);
    waiting_.clear();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kPatience{10};

  ros::Publisher publisher_;
  std::function<bool()> everybody_listens_;
  Clock::time_point first_;  // when the first message came
  std::deque<boost::shared_ptr<const T>> waiting_;
  bool open_ = false;
};

}  // namespace revisit_slam
