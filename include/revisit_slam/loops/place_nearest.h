// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "revisit_slam/loops/place_descriptor.h"

namespace revisit_slam {

struct NearestDescriptor {
  std::size_t index = 0;
  int distance = 0;  ///< bits
};

/// The first of the nearest of `descriptors[begin, end)` that are nearer than `bound` bits, else
/// {end, bound}. Runs the fastest version that the processor has; all give the same.
NearestDescriptor nearestDescriptor(const Descriptor& query, const Descriptor* descriptors,
                                    std::size_t begin, std::size_t end, int bound);

}  // namespace revisit_slam
