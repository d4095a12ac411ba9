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
/// have reached its end, or one is ahead of it by input/max_wait; the others are no longer waited
/// for until they are up again. What it holds depends on stamps alone, unless messages come later
/// than that. The clock is that of most of the sensors that send, of as many that of the one that
/// was first: messages of others that are seconds off it are dropped.
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
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

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
    std::int64_t oldest = kNever;      // of these
    std::optional<Stamp> reached;      // by its last message
    std::optional<ScanReading> ahead;  // of all others, to be confirmed by the next
    bool is_awaited = true;
    std::optional<Stamp> sent;       // by its last message, whatever became of that
    std::int64_t sent_for = 0;       // ns, by its own clock, without leaps
    std::vector<std::int64_t> then;  // sent_for of all sensors at its last message
    SensorAccount account;
  };

  void noteArrival(Sensor& sensor, Stamp stamp);
  bool hasGone(const Sensor& sensor) const;
  void chooseClock(std::size_t sender);
  std::size_t agreeingWith(const Sensor& sensor) const;
  bool isNear(Stamp a, Stamp b) const;
  bool isOfAnotherClock(std::size_t sensor, Stamp stamp) const;
  void drop(const ScanReading& reading, const std::string& reason);
  void accept(ScanReading reading, std::vector<ScanReading>& sweeps);
  void store(const Scan& scan, Sensor& sensor) const;
  bool isLeap(Stamp stamp) const;
  bool allReach(std::int64_t end) const;
  std::int64_t newest() const;
  std::optional<std::int64_t> oldestWindow() const;
  void close(std::vector<ScanReading>& sweeps);
  /// Nothing of less than `fewest` points, nor of the rest of a first one.
  std::optional<ScanReading> closeWindow(std::int64_t window, double fewest = 0.0);

  std::int64_t length_;    // ns
  std::int64_t max_wait_;  // ns
  std::int64_t leap_;      // ns: a stamp so far off has to be confirmed
  std::vector<Sensor> sensors_;
  std::optional<std::size_t> clock_;          // number of the sensor whose clock the sweeps have
  std::optional<std::int64_t> closed_until_;  // window behind the last one that was closed
  bool has_intensities_ = false;              // some sensor has
  std::size_t last_size_ = 0;                 // points of the last sweep
};

}  // namespace revisit_slam
