// SPDX-License-Identifier: MIT
#pragma once

#include <ros/console.h>

#include <mutex>
#include <string>

namespace revisit_slam {

/// What this process, with the nodelets in it, logs while the object lives.
class RosLog {
 public:
  RosLog() : begin_(appender().text().size()) {}

  std::string text() const { return appender().text().substr(begin_); }

 private:
  class Appender : public ros::console::LogAppender {
   public:
    Appender() { ros::console::register_appender(this); }

    void log(ros::console::Level, const char* text, const char*, const char*, int) override {
      const std::lock_guard<std::mutex> lock(mutex_);
      text_ += std::string(text) + "\n";
    }
    std::string text() const {
      const std::lock_guard<std::mutex> lock(mutex_);
      return text_;
    }

   private:
    mutable std::mutex mutex_;
    std::string text_;
  };

  /// Never deregistered: rosconsole of Debian 11 then frees it twice.
  static Appender& appender() {
    static auto* const appender = new Appender;
    return *appender;
  }

  std::size_t begin_;
};

}  // namespace revisit_slam
