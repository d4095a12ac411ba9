// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "options.h"

namespace revisit_slam::simulation {

struct Summary {
  std::vector<Stamp> last_points;
  std::uint64_t points = 0;
};

/// Writes all scans, and what the other sensors measure; the bag is whole when this returns.
Summary writeBag(const Options& o, const World& world, const Route& route,
                 const ScanSimulator& simulator, int count);

}  // namespace revisit_slam::simulation
