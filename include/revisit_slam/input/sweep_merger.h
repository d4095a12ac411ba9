// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/input/scan_input_config.h"
#include "revisit_slam/input/scan_reading.h"
#include "revisit_slam/types/sensor_account.h"

namespace revisit_slam {

/// Makes one sweep of what several sensors saw in the same time: windows of one length, on a grid
/// of absolute time, each with all points whose times are in it. So sensors may have any rates and
/// phases, and none of them is needed for those of the others. A window is closed when all sensors
/// have reached its end, or one is ahead of it by input/max_wait; then the others count as silent
/// until they are up again. What it holds depends on stamps alone, unless messages come later than
/// that.
class SweepMerger {
 public:
  /// @throws ParameterError for ranges or offsets that are none, or of another number of sensors.
  explicit SweepMerger(const ScanInputConfig& config);

  /// Whether there are several sensors.
  bool merges() const { return sensors_.size() > 1; }

  /// The sweeps that are complete with this reading, which has a scan. Their points are sorted by
  /// sensor (Scan::views).
  std::vector<ScanReading> take(ScanReading reading);
  /// No message comes after those held.
  std::vector<ScanReading> flush();
  /// Forgets what is held; the accounts begin anew.
  void restart();

  /// Messages of which points wait, about.
  std::size_t held() const;
  /// By topic.
  std::map<std::string, SensorAccount> accounts() const;

 private:
  struct Point {
    std::int64_t nanoseconds;  // since 1970
    Eigen::Vector3f p_sensor;
    float intensity;
  };
  struct Sensor {
    std::string topic;
    float nearest = 0.0f, farthest = std::numeric_limits<float>::infinity();  // m^2
    double time_offset = 0.0;                                                 // s
    Pose T_base_sensor;
    std::string frame_id;
    std::vector<Point> points;         // that wait, in the order of messages
    std::optional<Stamp> reached;      // by its last message
    std::optional<ScanReading> ahead;  // of all others, to be confirmed by the next
    SensorAccount account;
  };

  void accept(ScanReading reading, std::vector<ScanReading>& sweeps);
  void store(const Scan& scan, Sensor& sensor) const;
  bool isLeap(const Sensor& sensor, Stamp stamp) const;
  bool allReach(std::int64_t end) const;
  std::int64_t newest() const;
  std::optional<std::int64_t> oldestWindow() const;
  void close(std::vector<ScanReading>& sweeps);
  /// Nothing of less than `fewest` points, nor of the rest of a first one.
  std::optional<ScanReading> closeWindow(std::int64_t window, double fewest = 0.0);

  std::int64_t length_;    // ns
  std::int64_t max_wait_;  // ns
  std::vector<Sensor> sensors_;
  std::optional<std::int64_t> closed_until_;  // window behind the last one that was closed
  bool has_intensities_ = false;              // some sensor has
  std::size_t last_size_ = 0;                 // points of the last sweep
};

}  // namespace revisit_slam
