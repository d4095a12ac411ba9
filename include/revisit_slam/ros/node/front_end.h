// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/types/scan_account.h"
#include "revisit_slam/information/information_estimator.h"
#include "revisit_slam/odometry/odometry.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/ros/input/scan_reader.h"

namespace revisit_slam {

/// From a message to a registered scan that carries its registration problem, with an account of
/// everything that was dropped. The offline
/// runner and the odometry nodelet both consist of it, which is why they give the same poses.
class FrontEnd {
 public:
  explicit FrontEnd(const SlamConfig& config);
  FrontEnd(const FrontEnd&) = delete;
  FrontEnd& operator=(const FrontEnd&) = delete;

  struct Result {
    std::optional<RegisteredScan> scan;
    std::string rejection;  ///< why there is no scan
    StageTimes times;
  };

  /// `Message`: sensor_msgs::PointCloud2, or topic_tools::ShapeShifter for Livox messages.
  template <typename Message>
  Result process(const Message& message);

  /// Counts a message that never reached `process`.
  void countDropped(const std::string& reason);

  void setExtrinsics(const Pose& T_base_sensor) { reader_.setExtrinsics(T_base_sensor); }
  void reconfigure(const OdometryConfig& config) { odometry_.reconfigure(config); }

  const ScanAccount& account() const { return account_; }
  const Odometry& odometry() const { return odometry_; }
  /// One line on where the point times come from; empty before the first scan.
  const std::string& timeSource() const { return reader_.description(); }

 private:
  Result registerReading(ScanReading reading, StageClock clock);
  Result reject(const char* reason, const std::string& detail);

  ScanReader reader_;
  InformationEstimator information_;
  Odometry odometry_;
  ScanAccount account_;
};

}  // namespace revisit_slam
