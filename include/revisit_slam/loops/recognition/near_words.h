// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace revisit_slam {

/// Writes to `near` the numbers of those of `count` words that differ from `query` in at most
/// `max_distance` bits, in order, and returns how many; `near` has room for all.
std::size_t findNearWords(std::uint64_t query, const std::uint64_t* words, std::size_t count,
                          int max_distance, std::uint32_t* near);

}  // namespace revisit_slam
