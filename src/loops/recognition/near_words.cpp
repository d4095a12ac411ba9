// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/near_words.h"

#if defined(__x86_64__) && defined(__GNUC__)
#define REVISIT_SLAM_HAS_VERSIONS
#endif

namespace revisit_slam {
namespace {

/// Without a branch that depends on the data: which words are near cannot be foreseen.
inline __attribute__((always_inline)) std::size_t search(std::uint64_t query,
                                                         const std::uint64_t* words,
                                                         std::size_t count, int max_distance,
                                                         std::uint32_t* near) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    near[found] = static_cast<std::uint32_t>(i);
    found += __builtin_popcountll(query ^ words[i]) <= max_distance ? 1 : 0;
  }
  return found;
}

std::size_t searchAnywhere(std::uint64_t query, const std::uint64_t* words, std::size_t count,
                           int max_distance, std::uint32_t* near) {
  return search(query, words, count, max_distance, near);
}

#ifdef REVISIT_SLAM_HAS_VERSIONS
__attribute__((target("popcnt"))) std::size_t searchByWord(std::uint64_t query,
                                                           const std::uint64_t* words,
                                                           std::size_t count, int max_distance,
                                                           std::uint32_t* near) {
  return search(query, words, count, max_distance, near);
}
#endif

std::vector<WordSearch*> searchesHere() {
  std::vector<WordSearch*> searches{searchAnywhere};
#ifdef REVISIT_SLAM_HAS_VERSIONS
  if (__builtin_cpu_supports("popcnt")) searches.push_back(searchByWord);
#endif
  return searches;
}

}  // namespace

const std::vector<WordSearch*>& wordSearches() {
  static const std::vector<WordSearch*> searches = searchesHere();
  return searches;
}

}  // namespace revisit_slam
