// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include "revisit_slam/input/scan_input_config.h"
#include "revisit_slam/input/viewed_directions.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// What the messages of a sensor are.
struct SweepForm {
  /// Of a sweep, where messages hold a part of one, s; 0: every message is a sweep.
  double sweep_seconds = 0.0;
  /// Sweeps last so many times longer, by their point times, than it takes to the next. That cannot
  /// be; 0: they do not.
  double stretch = 0.0;
};

/// Recognises what messages are by the directions that they cover one after the other, and by how
/// long they last and how often they come:
/// - A spinning sensor whose messages cover other directions than the messages before delivers
///   parts of a revolution.
/// - Messages of a fixed field of view are parts where they come too often to be registered one by
///   one.
/// - All others are sweeps, and so is at once a first message that covers the full circle.
class SweepRecognition {
 public:
  explicit SweepRecognition(const ScanInputConfig& config);

  /// Scans as they come. Those of several sensors in turn are held to be sweeps.
  void add(const Scan& scan, const std::string& frame_id);

  bool isDecided() const { return is_decided_; }
  const SweepForm& form() const { return form_; }
  /// Between two messages, mean of the latest, s.
  double interval() const { return interval_; }
  /// One line on what is unusual about the messages, and what to do about it; else empty.
  const std::string& description() const { return description_; }

 private:
  struct Message {
    Stamp stamp;
    double seconds = 0.0;  // that it lasts by its point times; 0: not known
    ViewedDirections directions;
    bool is_full_circle = false;
  };
  struct Group {
    double seconds = 0.0;     // that it lasts
    double seconds_to = 0.0;  // from the oldest message to its middle
    ViewSector sector;
  };

  void judge();
  void decide(const SweepForm& form);
  std::size_t messagesInGroup() const;
  double stretch() const;
  double sweepSeconds(std::size_t messages_in_group) const;
  double shortestInterval() const;
  Group groupOf(std::size_t begin, std::size_t count) const;

  bool is_automatic_;
  double given_seconds_;  // of a sweep; 0: not given
  std::deque<Message> messages_;
  double interval_ = 0.0;
  std::string frame_id_;
  bool is_decided_ = false;
  int contrary_ = 0;  // judgements in a row that were not what is decided
  SweepForm form_;
  std::string description_;
};

}  // namespace revisit_slam
