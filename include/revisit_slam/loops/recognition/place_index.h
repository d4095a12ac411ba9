// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "revisit_slam/loops/recognition/place_features.h"

namespace revisit_slam {

/// How places that look alike are looked up among many.
struct PlaceIndexConfig {
  int tables = 24;          ///< each hashes a choice of bits of its own
  int usual_bucket = 8;     ///< entries of a bucket on average
  int largest_bucket = 64;  ///< entries of a bucket that are looked at
  int max_distance = 45;    ///< bits, between features that speak for each other
  std::uint32_t seed = 1;   ///< of the choice of bits
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
  /// What a thread needs to look up.
  class Lookup;

  /// The `count` places with most votes of the features, most first, without those of
  /// [excluded_begin, excluded_end).
  std::vector<Vote> similar(const PlaceFeatures& features, std::size_t excluded_begin,
                            std::size_t excluded_end, std::size_t count, Lookup& lookup) const;

 private:
  /// A part of the entries of a table.
  struct Bucket {
    std::size_t begin, size;
  };

  /// How a place may be turned to another: sectors of the circle. An alignment has turns of two
  /// neighbours, as those of features are known to about 0.35 rad.
  static constexpr std::size_t kTurns = 16;

  /// What a vote needs of a feature, in one line of the cache.
  struct Feature {
    Descriptor descriptor;
    float angle;
    std::uint32_t place;
  };
  /// Its entries are ordered by bucket. What is looked at of all entries of a bucket lies side by
  /// side.
  struct Table {
    std::vector<std::uint8_t> bits;       // that it hashes
    std::size_t word;                     // of the descriptor, that its entries have
    std::vector<std::uint32_t> begins;    // of the buckets, and the end of the last
    std::vector<std::uint64_t> words;     // of the entries
    std::vector<std::uint32_t> features;  // of the entries
  };

  template <typename Meet>
  void forEachAlike(const Descriptor& descriptor, Lookup& lookup, const Meet& meet) const;
  void addNear(const Descriptor& descriptor, std::size_t table, Lookup& lookup) const;
  Bucket bucketOf(const Table& table, std::uint32_t key) const;
  static std::uint32_t keyOf(const Descriptor& descriptor, const std::vector<std::uint8_t>& bits);
  void fill(Table& table) const;
  static std::uint32_t takeBestTurn(std::size_t place, std::vector<std::uint32_t>& counts);

  std::size_t places_, largest_bucket_;
  int max_distance_, max_word_distance_;
  std::vector<Feature> features_;  // of all places
  std::vector<Table> tables_;
};

class PlaceIndex::Lookup {
 public:
  explicit Lookup(const PlaceIndex& index);

 private:
  friend class PlaceIndex;
  std::vector<std::uint32_t> counts_;  // votes by place and turn, 0 between look-ups
  std::vector<std::uint32_t> keys_;    // by table
  std::vector<Bucket> buckets_;        // by table
  std::vector<std::uint32_t> near_;    // entries of a bucket
  std::vector<std::uint32_t> alike_;   // features
};

}  // namespace revisit_slam
