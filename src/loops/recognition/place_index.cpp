// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kDescriptorBits = 256;
constexpr std::size_t kFewestBits = 8, kMostBits = 24;  // 24: 64 MB of a table's begins

constexpr std::uint32_t kScatter = 2654435761u;  // Knuth's multiplicative hash

/// Of `sectors` of the circle the one that an angle in (-4 pi, 4 pi) is in.
std::size_t sectorOf(float angle, std::size_t sectors) {
  const double turns = angle / (2.0 * M_PI) + 2.0;
  return static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(sectors)) %
         sectors;
}

/// Buckets of one or two entries.
std::size_t bitsFor(std::size_t descriptors) {
  std::size_t bits = kFewestBits;
  while (bits < kMostBits && (std::size_t{2} << bits) < descriptors) ++bits;
  return bits;
}

/// A choice without repetition; by hand, as std::shuffle differs between libraries.
std::vector<std::uint8_t> choose(std::size_t count, std::mt19937& random) {
  std::array<std::uint8_t, kDescriptorBits> all{};
  std::iota(all.begin(), all.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < count; ++i) std::swap(all[i], all[i + random() % (all.size() - i)]);
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

PlaceIndex::PlaceIndex(const std::vector<const PlaceFeatures*>& places,
                       const PlaceIndexConfig& config)
    : places_(places.size()),
      largest_bucket_(static_cast<std::size_t>(config.largest_bucket)),
      max_distance_(config.max_distance),
      tables_(static_cast<std::size_t>(config.tables)) {
  for (std::size_t place = 0; place < places.size(); ++place)
    for (std::size_t i = 0; i < places[place]->size(); ++i)
      features_.push_back({places[place]->descriptors[i], places[place]->keypoints[i].angle,
                           static_cast<std::uint32_t>(place)});
  std::mt19937 random(config.seed);
  for (Table& table : tables_) table.bits = choose(bitsFor(features_.size()), random);
  Chunks(tables_.size(), 1).forEach([&](std::size_t index, Chunk) { fill(tables_[index]); });
}

std::uint32_t PlaceIndex::keyOf(const Descriptor& descriptor,
                                const std::vector<std::uint8_t>& bits) {
  std::uint32_t key = 0;
  for (const std::uint8_t bit : bits)
    key = (key << 1) | static_cast<std::uint32_t>((descriptor[bit / 64] >> (bit % 64)) & 1u);
  return key;
}

/// Counting sort by key.
void PlaceIndex::fill(Table& table) const {
  table.begins.assign((std::size_t{1} << table.bits.size()) + 1, 0);
  std::vector<std::uint32_t> keys;
  keys.reserve(features_.size());
  for (const Entry& feature : features_) {
    keys.push_back(keyOf(feature.descriptor, table.bits));
    ++table.begins[keys.back() + 1];
  }
  std::partial_sum(table.begins.begin(), table.begins.end(), table.begins.begin());
  table.entries.resize(keys.size());
  std::vector<std::uint32_t> next(table.begins.begin(), table.begins.end() - 1);
  for (std::size_t i = 0; i < keys.size(); ++i)
    table.entries[next[keys[i]]++] = static_cast<std::uint32_t>(i);
}

/// Features of the index that share a bucket with the descriptor and are near it; once for each
/// bucket.
template <typename Meet>
void PlaceIndex::forEachAlike(const Descriptor& descriptor, const Meet& meet) const {
  for (const Table& table : tables_) {
    const std::uint32_t key = keyOf(descriptor, table.bits);
    const std::size_t begin = table.begins[key], size = table.begins[key + 1] - begin;
    // Of a large bucket a part that is another one for each key, so that all have a say.
    const std::size_t first = size > largest_bucket_ ? key * kScatter % size : 0;
    for (std::size_t i = 0; i < std::min(size, largest_bucket_); ++i) {
      const std::size_t at = first + i < size ? first + i : first + i - size;
      const Entry& entry = features_[table.entries[begin + at]];
      if (differingBits(descriptor, entry.descriptor) <= max_distance_) meet(entry);
    }
  }
}

std::vector<PlaceIndex::Vote> PlaceIndex::similar(const PlaceFeatures& features,
                                                  std::size_t excluded_begin,
                                                  std::size_t excluded_end, std::size_t count,
                                                  Counts& counts) const {
  std::vector<std::uint32_t> met;
  for (std::size_t i = 0; i < features.size(); ++i)
    forEachAlike(features.descriptors[i], [&](const Entry& entry) {
      if (entry.place >= excluded_begin && entry.place < excluded_end) return;
      const std::size_t turn = sectorOf(entry.angle - features.keypoints[i].angle, kTurns);
      if (counts[kTurns * entry.place + turn]++ == 0) met.push_back(entry.place);
    });
  std::vector<Vote> votes;
  for (const std::uint32_t place : met)
    if (const std::uint32_t most = takeBestTurn(place, counts)) votes.push_back({place, most});
  const auto most = votes.begin() + static_cast<std::ptrdiff_t>(std::min(count, votes.size()));
  std::partial_sort(votes.begin(), most, votes.end(), [](const Vote& a, const Vote& b) {
    return a.votes != b.votes ? a.votes > b.votes : a.place < b.place;
  });
  votes.erase(most, votes.end());
  return votes;
}

/// The most votes of two neighbouring sectors; the counts of the place are cleared.
std::uint32_t PlaceIndex::takeBestTurn(std::size_t place, Counts& counts) {
  std::array<std::uint32_t, kTurns> turns{};
  for (std::size_t turn = 0; turn < kTurns; ++turn)
    turns[turn] = std::exchange(counts[kTurns * place + turn], 0);
  std::uint32_t best = 0;
  for (std::size_t turn = 0; turn < kTurns; ++turn)
    best = std::max(best, turns[turn] + turns[(turn + 1) % kTurns]);
  return best;
}

}  // namespace revisit_slam
