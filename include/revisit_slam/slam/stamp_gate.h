// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/input/scan_reading.h"

namespace revisit_slam {

/// Decides by its stamp what becomes of a scan. One stamp alone does not tell whether the clock was
/// set, the recording has a gap, or the stamp is wrong: what does not follow the scan before is
/// held until the scans after it have told.
class StampGate {
 public:
  /// A gap of more than a few periods between two scans, and one longer than `max_gap` (s) in any
  /// case, has to be confirmed by the next scan. `restart_after`: so many scans in a row from
  /// before the newest, in order, are another clock.
  StampGate(double max_gap, int restart_after)
      : max_gap_(max_gap), restart_after_(static_cast<std::size_t>(restart_after)) {}

  struct Decision {
    ScanReading reading;  ///< with its scan
    std::string refusal;  ///< empty: the scan goes on
    /// How far the clock went back where this scan is the first of another session, s.
    std::optional<double> went_back;
  };

  /// The decisions that fall with this reading, which has a scan; often its own.
  std::vector<Decision> take(ScanReading reading);

  /// No scan comes after those held.
  std::vector<Decision> flush();

  /// Scans before the next one are known to be missing: a gap of some periods needs no
  /// confirmation.
  void expectGap() { gap_is_expected_ = true; }

  /// The next scan follows none.
  void restart();

  std::size_t held() const { return behind_.size() + (ahead_ ? 1 : 0); }

 private:
  bool isGap(double seconds) const;
  void judgeAhead(Stamp next, std::vector<Decision>& decisions);
  void hold(ScanReading reading, std::vector<Decision>& decisions);
  void refuseBehind(std::vector<Decision>& decisions);
  void pass(ScanReading reading, std::vector<Decision>& decisions);

  double max_gap_;
  std::size_t restart_after_;
  std::optional<Stamp> last_;  // that went on
  double period_ = 0.0;        // s, of late the longest between two that went on; 0: none yet
  bool gap_is_expected_ = false;
  std::optional<ScanReading> ahead_;  // after a gap
  std::vector<ScanReading> behind_;   // older than last_, in order
};

}  // namespace revisit_slam
