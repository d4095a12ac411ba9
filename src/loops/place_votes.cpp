// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/place_votes.h"

#include <algorithm>

namespace revisit_slam {
namespace {

std::uint16_t chunkOf(const Descriptor& descriptor, std::size_t index) {
  return static_cast<std::uint16_t>(descriptor[index / 4] >> (16 * (index % 4)));
}

}  // namespace

PlaceVotes::PlaceVotes(const std::vector<Descriptor>& query)
    : query_(query), occurs_(std::make_unique<std::array<std::bitset<65536>, kChunks>>()) {
  for (std::size_t chunk = 0; chunk < kChunks; ++chunk) {
    std::vector<Chunk>& sorted = sorted_[chunk];
    for (std::size_t i = 0; i < query.size(); ++i) {
      sorted.push_back({chunkOf(query[i], chunk), static_cast<std::uint16_t>(i)});
      (*occurs_)[chunk].set(sorted.back().bits);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Chunk& a, const Chunk& b) { return a.bits < b.bits; });
  }
}

REVISIT_SLAM_COUNTS_BITS
bool meets(const PlaceVotes& votes, const Descriptor& descriptor, int max_distance) {
  for (std::size_t chunk = 0; chunk < PlaceVotes::kChunks; ++chunk) {
    const std::uint16_t bits = chunkOf(descriptor, chunk);
    if (!(*votes.occurs_)[chunk][bits]) continue;
    const auto& sorted = votes.sorted_[chunk];
    auto entry = std::lower_bound(sorted.begin(), sorted.end(), bits,
                                  [](const auto& a, std::uint16_t b) { return a.bits < b; });
    for (; entry != sorted.end() && entry->bits == bits; ++entry)
      if (differingBits(votes.query_[entry->feature], descriptor) <= max_distance) return true;
  }
  return false;
}

int PlaceVotes::count(const std::vector<Descriptor>& map, int max_distance) const {
  int met = 0;
  for (const Descriptor& descriptor : map) met += meets(*this, descriptor, max_distance);
  return met;
}

}  // namespace revisit_slam
