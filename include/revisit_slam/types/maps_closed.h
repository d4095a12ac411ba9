// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "revisit_slam/types/ids.h"

namespace revisit_slam {

/// All maps of the first `scans` scans of a session are closed and searched for loops.
struct MapsClosed {
  SessionId session;
  std::uint32_t scans = 0;
  std::uint32_t request = 0;  ///< what it answers; 0: the next session began
};

}  // namespace revisit_slam
