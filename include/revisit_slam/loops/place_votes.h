// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstdint>
#include <memory>
#include <vector>

#include "revisit_slam/loops/place_descriptor.h"

namespace revisit_slam {

/// Estimates quickly how much a map resembles the query, to choose the maps that are worth an exact
/// comparison. A descriptor of 256 bits is cut into 16 chunks; two descriptors meet if they share
/// any whole chunk, as nearly all do that differ in few bits (locality-sensitive hashing by bit
/// sampling, Indyk and Motwani 1998). The hash is that of the query, so that maps keep none.
class PlaceVotes {
 public:
  explicit PlaceVotes(const std::vector<Descriptor>& query);

  /// How many of the map's descriptors meet one of the query within `max_distance` bits.
  int count(const std::vector<Descriptor>& map, int max_distance) const;

 private:
  static constexpr std::size_t kChunks = 16;

  struct Chunk {
    std::uint16_t bits;
    std::uint16_t feature;
  };

  std::vector<Descriptor> query_;
  /// For each chunk: which values occur in the query, and where.
  std::unique_ptr<std::array<std::bitset<65536>, kChunks>> occurs_;
  std::array<std::vector<Chunk>, kChunks> sorted_;

  friend bool meets(const PlaceVotes& votes, const Descriptor& descriptor, int max_distance);
};

}  // namespace revisit_slam
