// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/near_words.h"

#include "revisit_slam/util/vector_clones.h"

namespace revisit_slam {

/// Without a branch that depends on the data: which words are near cannot be foreseen. Processors
/// with wide registers count bits by one instruction.
REVISIT_SLAM_VECTOR_CLONES
std::size_t findNearWords(std::uint64_t query, const std::uint64_t* words, std::size_t count,
                          int max_distance, std::uint32_t* near) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    near[found] = static_cast<std::uint32_t>(i);
    found += __builtin_popcountll(query ^ words[i]) <= max_distance ? 1 : 0;
  }
  return found;
}

}  // namespace revisit_slam
