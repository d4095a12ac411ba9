// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "revisit_slam/types/ids.h"

namespace revisit_slam {

/// Where a scan stands among those that came before it.
enum class ScanOrder {
  first,  ///< of a new session
  next,
  repeated,  ///< the base rests: the scan before stands for it
  missed,    ///< scans before it were not seen: of no use for maps and graph
};

/// Follows the scans of session after session.
class SessionOrder {
 public:
  ScanOrder take(ScanId id) {
    if (session_ != id.session && id.value == 0) {
      session_ = id.session;
      scans_ = 1;
      return ScanOrder::first;
    }
    if (session_ == id.session && id.value + 1 == scans_) return ScanOrder::repeated;
    if (session_ != id.session || id.value != scans_) return ScanOrder::missed;
    ++scans_;
    return ScanOrder::next;
  }

  std::optional<SessionId> session() const { return session_; }
  /// Of the session.
  std::uint32_t scans() const { return scans_; }

 private:
  std::optional<SessionId> session_;
  std::uint32_t scans_ = 0;
};

}  // namespace revisit_slam
