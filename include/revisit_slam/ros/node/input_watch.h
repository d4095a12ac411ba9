// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "revisit_slam/ros/input/scan_topics.h"
#include "revisit_slam/types/scan_account.h"

namespace revisit_slam {

/// What an odometry node knows of its input at one moment.
struct InputState {
  double now = 0.0;                 ///< s, of a clock that does not stand still
  std::vector<std::string> topics;  ///< that it listens to
  bool several_sensors = false;     ///< whose scans are merged, one topic each
  /// By anybody; has to be known only where InputWatch::isSilent().
  std::vector<TypedTopic> published;
  std::size_t arrived = 0;  ///< messages with scans, ever
  std::size_t waiting = 0;  ///< of them
  bool clock_runs = true;
  /// Why scans cannot be placed on the robot, and the remedy; empty where they can.
  std::string transform_fault;
  double scan_seconds = 0.0;  ///< that the odometry takes for one, of late
  ScanAccount account;
  /// Why there is no deskewing, and the remedy; empty where nothing has to be done.
  std::string time_fault;
};

/// Judges from one look to the next whether a user has to act, and says what to do.
class InputWatch {
 public:
  enum class Level { ok, warn, error };
  enum class Fault {
    none,
    clock,
    nothing_comes,
    stopped,
    transform,
    all_dropped,
    overload,
    some_dropped,
    no_times,
  };

  struct Verdict {
    Level level = Level::ok;
    Fault fault = Fault::none;
    std::string sentence;
    bool is_new = false;  ///< another fault than at the look before: to be logged
  };

  /// Whether nothing has come for so long that somebody should look why.
  bool isSilent(double now, std::size_t arrived) const;

  Verdict look(const InputState& state);

 private:
  struct Arrival {
    double now;
    std::size_t arrived;
  };

  void note(const InputState& state);
  double rate() const;  // Hz, of the last seconds
  std::optional<Verdict> judgeArrival(const InputState& state) const;
  Verdict judgeTransform(const InputState& state) const;
  std::optional<Verdict> judgeDrops(const InputState& state) const;
  std::string describeStop(const InputState& state) const;
  std::string describeOverload(const InputState& state, std::size_t dropped) const;

  std::optional<double> start_;   // of the first look
  std::deque<Arrival> arrivals_;  // of the last seconds
  double last_rate_ = 0.0;        // Hz, when scans came
  double last_arrival_ = 0.0;     // s
  ScanAccount before_;            // at the last look
  std::map<std::string, std::size_t> newly_dropped_;
  std::size_t newly_processed_ = 0;
  Fault fault_ = Fault::none;
  std::string cause_;  // of silence
};

}  // namespace revisit_slam
