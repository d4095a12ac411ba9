// SPDX-License-Identifier: MIT
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <nodelet/nodelet.h>
#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/util/busy_share.h"
#include "revisit_slam/util/lane.h"

namespace revisit_slam {

/// What all nodelets have in common: they read their parameters, start, and report how they are.
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

  /// A thread for work of the stage, with its load in the diagnostics. What the work throws is
  /// reported and counted, and the stage goes on.
  std::unique_ptr<ThreadLane> makeLane(const std::string& work, int niceness);
  /// Puts the load by that work into the diagnostics: `busy_seconds` tells how long it has taken so
  /// far, until stopDiagnostics().
  void watchLoad(const std::string& work, std::function<double()> busy_seconds);
  /// For diagnostics, where it is told once. Thread-safe.
  void noteError(const std::string& error);

  /// Does work, and reports and counts what it throws: whatever leaves a callback or a thread ends
  /// the process, and the drivers in it.
  template <typename Work>
  void guarded(const Work& work) {
    try {
      work();
    } catch (const std::exception& error) {
      noteError(error.what());
    } catch (...) {
      noteError("an error of no known kind");
    }
  }

  SlamConfig config_;

 private:
  void onInit() override;
  void publishDiagnostics();
  void tellLoads(diagnostic_msgs::DiagnosticStatus& status);
  void tellErrors(diagnostic_msgs::DiagnosticStatus& status);

  const std::string part_;
  ros::Publisher diagnostics_publisher_;
  ros::WallTimer diagnostics_timer_;

  struct Load {
    std::string work;
    std::function<double()> busy_seconds;
    BusyShare share;
  };
  std::vector<Load> loads_;

  std::mutex errors_mutex_;  // guards the next two
  std::size_t errors_ = 0;
  std::string untold_error_;
};

}  // namespace revisit_slam
