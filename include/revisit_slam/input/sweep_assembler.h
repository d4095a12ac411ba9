// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "revisit_slam/input/scan_reading.h"
#include "revisit_slam/input/sweep_recognition.h"

namespace revisit_slam {

/// Makes sweeps of the messages of a sensor, whatever part of a sweep each of them holds. Messages
/// that are sweeps go through unchanged and at once; of others the first ones wait until
/// SweepRecognition has told what they are.
///
/// Points keep their own times, and the stamp of a sweep is that of its last point. Parts without
/// point times have those of their messages. A sweep ends when it has lasted long enough, so that
/// a lost part leaves a hole in one sweep.
class SweepAssembler {
 public:
  explicit SweepAssembler(const ScanInputConfig& config) : config_(config), recognition_(config) {}

  struct Sweep {
    ScanReading reading;
    std::size_t messages = 1;  ///< of which it was made
    std::string refusal;       ///< empty: the sweep goes on
  };

  /// The sweeps that are complete with this reading, which has a scan.
  std::vector<Sweep> take(ScanReading reading);

  /// No message comes after those held.
  std::vector<Sweep> flush();

  /// Forgets what is held and what was recognised.
  void restart() { *this = SweepAssembler(config_); }

  std::size_t held() const { return undecided_.size() + parts_.size(); }
  /// What is unusual about the messages; changes only with that.
  const std::string& description() const { return recognition_.description(); }
  /// Whether point times are not used, as sweeps would overlap by them.
  bool doubtsTimes() const { return recognition_.form().stretch > 0.0; }

 private:
  void insert(ScanReading reading, std::vector<Sweep>& sweeps);
  Stamp beginOf(const Scan& scan) const;
  double lasted() const;
  bool continues(const ScanReading& reading) const;
  double tolerance() const;
  void close(std::vector<Sweep>& sweeps);

  ScanInputConfig config_;
  SweepRecognition recognition_;
  std::vector<ScanReading> undecided_;
  std::vector<ScanReading> parts_;  // of the sweep that has begun
};

}  // namespace revisit_slam
