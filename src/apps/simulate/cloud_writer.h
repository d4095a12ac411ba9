// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <string>

#include "revisit_slam/simulation/scan_simulator.h"
#include "revisit_slam/simulation/sensor_model.h"

namespace revisit_slam::simulation {

/// Writes the fields of one point after another into a message, as drivers of such sensors do.
class CloudWriter {
 public:
  CloudWriter(const SensorModel& sensor, bool with_times, bool with_labels)
      : kind_(sensor.kind), with_times_(with_times), with_labels_(with_labels) {}

  sensor_msgs::PointCloud2 write(const SimulatedScan& scan, std::uint32_t sequence,
                                 const std::string& frame = "lidar");

 private:
  void declareFields(sensor_msgs::PointCloud2& cloud) const;
  void putPoint(const SimulatedScan& scan, std::size_t i);
  template <typename T>
  void put(T value);

  SensorKind kind_;
  bool with_times_;
  bool with_labels_;
  std::uint8_t* target_ = nullptr;
};

}  // namespace revisit_slam::simulation
