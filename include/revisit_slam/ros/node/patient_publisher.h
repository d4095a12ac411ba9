// SPDX-License-Identifier: MIT
#pragma once

#include <ros/publisher.h>

#include <boost/shared_ptr.hpp>
#include <chrono>
#include <deque>
#include <functional>

namespace revisit_slam {

/// Nodelets are loaded in any order while the sensor runs already: what is published before those
/// that need it listen waits for them, so that they see every scan. Patience ends: whoever is not
/// there after 10 s is not expected any more. Only one thread may use it.
template <typename T>
class PatientPublisher {
 public:
  PatientPublisher() = default;
  PatientPublisher(ros::Publisher publisher, std::function<bool()> everybody_listens)
      : publisher_(std::move(publisher)), everybody_listens_(std::move(everybody_listens)) {}

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
