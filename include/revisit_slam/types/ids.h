// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>

namespace revisit_slam {

/// One run of the odometry: it ends where the odometry starts anew. What is numbered is numbered
/// within a session.
struct SessionId {
  std::uint32_t value = 0;

  friend bool operator==(SessionId a, SessionId b) { return a.value == b.value; }
  friend bool operator!=(SessionId a, SessionId b) { return a.value != b.value; }
  friend bool operator<(SessionId a, SessionId b) { return a.value < b.value; }
};

/// Names one thing of one kind by its number and session; ids of different kinds do not mix.
/// Ordered by session, then number.
template <typename Tag>
struct Id {
  std::uint32_t value = 0;  ///< the number, from 0
  SessionId session{};

  friend bool operator==(Id a, Id b) { return a.value == b.value && a.session == b.session; }
  friend bool operator!=(Id a, Id b) { return !(a == b); }
  friend bool operator<(Id a, Id b) {
    return std::pair(a.session.value, a.value) < std::pair(b.session.value, b.value);
  }
};

/// Counts the scans that the odometry registered, without gaps.
using ScanId = Id<struct ScanTag>;
using SubmapId = Id<struct SubmapTag>;
using LocalMapId = Id<struct LocalMapTag>;
/// Counts the loop constraints of a pose graph, without gaps.
using LoopId = Id<struct LoopTag>;

}  // namespace revisit_slam
