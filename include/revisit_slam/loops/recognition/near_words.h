// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace revisit_slam {

/// Writes to `near` the numbers of those of `count` words that differ from `query` in at most
/// `max_distance` bits, in order, and returns how many; `near` has room for all.
using WordSearch = std::size_t(std::uint64_t query, const std::uint64_t* words, std::size_t count,
                               int max_distance, std::uint32_t* near);

/// The versions that this processor can run, the fastest last; all give the same.
const std::vector<WordSearch*>& wordSearches();

}  // namespace revisit_slam
