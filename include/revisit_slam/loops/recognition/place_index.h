// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "revisit_slam/loops/recognition/place_features.h"

namespace revisit_slam {

/// How places that look alike are looked up among many.
struct PlaceIndexConfig {
  int tables = 64;           ///< each hashes a choice of bits of its own
  int largest_bucket = 256;  ///< entries of a bucket that are looked at
  int max_distance = 45;     ///< bits, between features that speak for each other
  std::uint32_t seed = 1;    ///< of the choice of bits
};

/// Finds the places that share most with a query without comparing it with all: bit sampling for
/// the Hamming distance (Indyk & Motwani, STOC 1998). Each table hashes a descriptor by some of its
/// bits, as many as make buckets of one or two entries; two descriptors that differ in few bits
/// share buckets in many tables. A pair of features votes for a place and a turn once for each
/// bucket that they share, so that the nearest count most. The work of a look-up does not grow with
/// the number of places, but for those that are alike. Approximate: what it names has to be
/// compared.
class PlaceIndex {
 public:
  /// The places by number, in the order given. Builds its tables in the current TBB arena; the same
  /// for any number of threads.
  PlaceIndex(const std::vector<const PlaceFeatures*>& places, const PlaceIndexConfig& config);

  /// A place and the votes for it.
  struct Vote {
    std::size_t place;
    std::uint32_t votes;
  };
  /// Votes by place and turn, for one thread.
  using Counts = std::vector<std::uint32_t>;
  Counts counts() const { return Counts(kTurns * places_, 0); }

  /// The `count` places with most votes of the features, most first, without those of
  /// [excluded_begin, excluded_end). `counts` is left as it came.
  std::vector<Vote> similar(const PlaceFeatures& features, std::size_t excluded_begin,
                            std::size_t excluded_end, std::size_t count, Counts& counts) const;

 private:
  /// How a place may be turned to another: sectors of the circle. An alignment has turns of two
  /// neighbours, as those of features are known to about 0.35 rad.
  static constexpr std::size_t kTurns = 16;

  /// What a look-up needs of a feature, in one line of the cache.
  struct Entry {
    Descriptor descriptor;
    float angle;
    std::uint32_t place;
  };
  struct Table {
    std::vector<std::uint8_t> bits;      // that it hashes
    std::vector<std::uint32_t> begins;   // of the buckets in `entries`, and the end of the last
    std::vector<std::uint32_t> entries;  // features
  };

  template <typename Meet>
  void forEachAlike(const Descriptor& descriptor, const Meet& meet) const;
  static std::uint32_t keyOf(const Descriptor& descriptor, const std::vector<std::uint8_t>& bits);
  void fill(Table& table) const;
  static std::uint32_t takeBestTurn(std::size_t place, Counts& counts);

  std::size_t places_, largest_bucket_;
  int max_distance_;
  std::vector<Entry> features_;  // of all places
  std::vector<Table> tables_;
};

}  // namespace revisit_slam
