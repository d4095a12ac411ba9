// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/input/sweep_assembler.h"
#include "revisit_slam/ros/input/finding.h"
#include "revisit_slam/ros/input/scan_reader.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/slam/stamp_gate.h"
#include "revisit_slam/types/scan_account.h"

namespace revisit_slam {

/// Looks at messages with scans as the odometry would, without registering them, and says whether
/// they can be used.
class ScanExamination {
 public:
  explicit ScanExamination(const SlamConfig& config);

  /// In the order of arrival, which has to be known.
  void add(const RawMessage& message);

  std::vector<Finding> findings();

  std::size_t messages() const { return account_.received; }
  /// Of the first message that could be read.
  const std::string& frame() const { return frame_; }

 private:
  void take(std::vector<SweepAssembler::Sweep> sweeps);
  void take(const std::vector<StampGate::Decision>& decisions);
  void measure(const ScanReading& reading);
  Finding aboutDrops() const;
  Finding aboutRate() const;
  Finding aboutStamps() const;
  Finding aboutTimes() const;
  Finding aboutPoints() const;
  Finding aboutRanges() const;

  const OdometryConfig odometry_;
  ScanReader reader_;
  SweepAssembler assembler_;
  StampGate gate_;
  ScanAccount account_;
  std::string frame_;
  std::vector<double> arrivals_;              // s
  std::vector<double> lateness_;              // s, of arrivals behind header stamps
  std::vector<double> used_shares_, counts_;  // of the points of each scan
  std::vector<double> ranges_;                // m, of some points of each scan
};

}  // namespace revisit_slam
