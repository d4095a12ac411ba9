// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "revisit_slam/loops/recognition/near_words.h"
#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kDescriptorWords = std::tuple_size<Descriptor>::value;
constexpr std::size_t kDescriptorBits = 64 * kDescriptorWords;
constexpr std::size_t kFewestBits = 8, kMostBits = 24;  // 24: 64 MB of a table's begins

constexpr std::uint32_t kScatter = 2654435761u;  // Knuth's multiplicative hash

/// Of `sectors` of the circle the one that an angle in (-4 pi, 4 pi) is in.
std::size_t sectorOf(float angle, std::size_t sectors) {
  const double turns = angle / (2.0 * M_PI) + 2.0;
  return static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(sectors)) %
         sectors;
}

/// That make buckets of `usual` entries.
std::size_t bitsFor(std::size_t descriptors, std::size_t usual) {
  std::size_t bits = kFewestBits;
  while (bits < kMostBits && (usual << bits) < descriptors) ++bits;
  return bits;
}

/// Of one of the words of descriptors that differ in at most `max_distance` bits, or rarely more:
/// so many standard deviations are allowed for.
int distanceOfWord(int max_distance) {
  constexpr double kShare = 64.0 / kDescriptorBits, kDeviations = 1.5;
  const double mean = kShare * max_distance;
  return static_cast<int>(mean + kDeviations * std::sqrt(mean * (1.0 - kShare)));
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
      max_word_distance_(distanceOfWord(config.max_distance)),
      tables_(static_cast<std::size_t>(config.tables)) {
  for (std::size_t place = 0; place < places.size(); ++place)
    for (std::size_t i = 0; i < places[place]->size(); ++i)
      features_.push_back({places[place]->descriptors[i], places[place]->keypoints[i].angle,
                           static_cast<std::uint32_t>(place)});
  const std::size_t bits = bitsFor(features_.size(), static_cast<std::size_t>(config.usual_bucket));
  std::mt19937 random(config.seed);
  for (std::size_t t = 0; t < tables_.size(); ++t) {
    tables_[t].bits = choose(bits, random);
    tables_[t].word = t % kDescriptorWords;
  }
  Chunks(tables_.size(), 1).forEach([&](std::size_t index, Chunk) { fill(tables_[index]); });
}

PlaceIndex::Lookup::Lookup(const PlaceIndex& index)
    : counts_(kTurns * index.places_, 0),
      keys_(index.tables_.size()),
      buckets_(index.tables_.size()),
      near_(index.largest_bucket_) {}

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
  for (const Feature& feature : features_) {
    keys.push_back(keyOf(feature.descriptor, table.bits));
    ++table.begins[keys.back() + 1];
  }
  std::partial_sum(table.begins.begin(), table.begins.end(), table.begins.begin());
  table.words.resize(keys.size());
  table.features.resize(keys.size());
  std::vector<std::uint32_t> next(table.begins.begin(), table.begins.end() - 1);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::uint32_t at = next[keys[i]]++;
    table.words[at] = features_[i].descriptor[table.word];
    table.features[at] = static_cast<std::uint32_t>(i);
  }
}

/// Of a large bucket a part that is another one for each key, so that all have a say.
PlaceIndex::Bucket PlaceIndex::bucketOf(const Table& table, std::uint32_t key) const {
  const std::size_t begin = table.begins[key], size = table.begins[key + 1] - begin;
  if (size <= largest_bucket_) return {begin, size};
  const std::size_t parts = (size + largest_bucket_ - 1) / largest_bucket_;
  const std::size_t part = key * kScatter % parts;
  return {begin + std::min(part * largest_bucket_, size - largest_bucket_), largest_bucket_};
}

/// Features of the index that share a bucket with the descriptor and are near it; once for each
/// bucket. What takes the time is waiting for memory: all is asked for before the first is looked
/// at.
template <typename Meet>
void PlaceIndex::forEachAlike(const Descriptor& descriptor, Lookup& lookup,
                              const Meet& meet) const {
  for (std::size_t t = 0; t < tables_.size(); ++t) {
    lookup.keys_[t] = keyOf(descriptor, tables_[t].bits);
    __builtin_prefetch(&tables_[t].begins[lookup.keys_[t]]);
  }
  for (std::size_t t = 0; t < tables_.size(); ++t) {
    lookup.buckets_[t] = bucketOf(tables_[t], lookup.keys_[t]);
    __builtin_prefetch(tables_[t].words.data() + lookup.buckets_[t].begin);
    __builtin_prefetch(tables_[t].features.data() + lookup.buckets_[t].begin);
  }
  lookup.alike_.clear();
  for (std::size_t t = 0; t < tables_.size(); ++t) addNear(descriptor, t, lookup);
  for (const std::uint32_t index : lookup.alike_) {
    const Feature& feature = features_[index];
    if (differingBits(descriptor, feature.descriptor) <= max_distance_) meet(feature);
  }
}

/// Of a bucket the features that have a word near that of the descriptor.
void PlaceIndex::addNear(const Descriptor& descriptor, std::size_t number, Lookup& lookup) const {
  const Table& table = tables_[number];
  const Bucket& bucket = lookup.buckets_[number];
  const std::uint32_t* features = table.features.data() + bucket.begin;
  const std::size_t count = findNearWords(descriptor[table.word], table.words.data() + bucket.begin,
                                          bucket.size, max_word_distance_, lookup.near_.data());
  for (std::size_t i = 0; i < count; ++i) {
    lookup.alike_.push_back(features[lookup.near_[i]]);
    __builtin_prefetch(&features_[lookup.alike_.back()]);
  }
}

std::vector<PlaceIndex::Vote> PlaceIndex::similar(const PlaceFeatures& features,
                                                  std::size_t excluded_begin,
                                                  std::size_t excluded_end, std::size_t count,
                                                  Lookup& lookup) const {
  std::vector<std::uint32_t> met;
  std::vector<std::uint32_t>& counts = lookup.counts_;
  for (std::size_t i = 0; i < features.size(); ++i)
    forEachAlike(features.descriptors[i], lookup, [&](const Feature& feature) {
      if (feature.place >= excluded_begin && feature.place < excluded_end) return;
      const std::size_t turn = sectorOf(feature.angle - features.keypoints[i].angle, kTurns);
      if (counts[kTurns * feature.place + turn]++ == 0) met.push_back(feature.place);
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
std::uint32_t PlaceIndex::takeBestTurn(std::size_t place, std::vector<std::uint32_t>& counts) {
  std::array<std::uint32_t, kTurns> turns{};
  for (std::size_t turn = 0; turn < kTurns; ++turn)
    turns[turn] = std::exchange(counts[kTurns * place + turn], 0);
  std::uint32_t best = 0;
  for (std::size_t turn = 0; turn < kTurns; ++turn)
    best = std::max(best, turns[turn] + turns[(turn + 1) % kTurns]);
  return best;
}

}  // namespace revisit_slam
