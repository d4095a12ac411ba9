// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace revisit_slam {

/// A number that names one thing of one kind; ids of different kinds do not mix.
template <typename Tag>
struct Id {
  std::uint32_t value = 0;

  friend bool operator==(Id a, Id b) { return a.value == b.value; }
  friend bool operator!=(Id a, Id b) { return a.value != b.value; }
  friend bool operator<(Id a, Id b) { return a.value < b.value; }
};

/// Counts the scans that the odometry registered, from 0, without gaps.
using ScanId = Id<struct ScanTag>;
using SubmapId = Id<struct SubmapTag>;
using LocalMapId = Id<struct LocalMapTag>;
/// Counts the loop constraints of a pose graph, from 0, without gaps.
using LoopId = Id<struct LoopTag>;

}  // namespace revisit_slam
