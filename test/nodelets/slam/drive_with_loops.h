// SPDX-License-Identifier: MIT
#pragma once

#include "support/live_slam.h"
#include "support/offline_program.h"

namespace revisit_slam {

/// A simulated drive down a street and back, and what the offline program makes of it.
class DriveWithLoops {
 public:
  DriveWithLoops() {
    ChildProcess simulate({REVISIT_SLAM_SIMULATE_PROGRAM, "--out", bag(), "--world", "town",
                           "--route", "opposite", "--length", "700", "--seed", "1", "--sensor",
                           "spinning-16", "--columns", "512", "--static", "--quiet", "--gnss",
                           "--imu"});
    if (simulate.wait(300.0) != 0) ADD_FAILURE() << simulate.output();
    offline = std::make_unique<OfflineProgram>(
        bag(), std::vector<std::string>{"--set", "frames/base=", "--quiet"});
    EXPECT_EQ(offline->status, 0) << offline->output;
    clouds = scansOf(bag());
  }

  std::string bag() const { return folder_.file("drive.bag"); }

  /// The same for all tests.
  static DriveWithLoops& get() {
    static DriveWithLoops drive;
    return drive;
  }

  std::unique_ptr<OfflineProgram> offline;
  std::vector<LiveSlam::CloudPtr> clouds;

 private:
  TemporaryFolder folder_;
};

}  // namespace revisit_slam
