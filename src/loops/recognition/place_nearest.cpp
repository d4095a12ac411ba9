// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_nearest.h"

#if defined(__x86_64__) && defined(__GNUC__)
#define REVISIT_SLAM_HAS_VERSIONS
#include <immintrin.h>
#pragma GCC diagnostic ignored "-Wuninitialized"  // within that header (GCC bug 105593)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace revisit_slam {
namespace {

using Block = DescriptorBlock;
using Blocks = std::vector<DescriptorBlock>;
constexpr std::size_t kLanes = std::tuple_size<Block::value_type>::value;

/// Stopping after half of the bits would not pay: a third of all pairs is still within the bound.
inline __attribute__((always_inline)) NearestDescriptor search(const Descriptor& query,
                                                               const Blocks& blocks,
                                                               NearestDescriptor best) {
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const int distance =
          differingBits(query, {block[0][lane], block[1][lane], block[2][lane], block[3][lane]});
      if (distance < best.distance) best = {b * kLanes + lane, distance};
    }
  }
  return best;
}

NearestDescriptor searchAnywhere(const Descriptor& query, const Blocks& blocks,
                                 NearestDescriptor best) {
  return search(query, blocks, best);
}

#ifdef REVISIT_SLAM_HAS_VERSIONS
/// With the instruction that counts the bits of one word.
__attribute__((target("popcnt"))) NearestDescriptor searchByWord(const Descriptor& query,
                                                                 const Blocks& blocks,
                                                                 NearestDescriptor best) {
  return search(query, blocks, best);
}

#define REVISIT_SLAM_EIGHT_WORDS \
  __attribute__((always_inline, target("popcnt,avx512f,avx512vpopcntdq")))

/// With the instruction that counts those of eight: each lane keeps its own nearest. Four blocks in
/// which no lane finds a nearer one are done with one comparison.
__attribute__((target("popcnt,avx512f,avx512vpopcntdq"))) NearestDescriptor searchByEightWords(
    const Descriptor& query, const Blocks& blocks, NearestDescriptor best) {
  const __m512i q[] = {
      _mm512_set1_epi64(static_cast<long long>(query[0])),
      _mm512_set1_epi64(static_cast<long long>(query[1])),
      _mm512_set1_epi64(static_cast<long long>(query[2])),
      _mm512_set1_epi64(static_cast<long long>(query[3])),
  };
  const auto differing = [&q](const Block& block, int word) REVISIT_SLAM_EIGHT_WORDS {
    return _mm512_popcnt_epi64(_mm512_xor_si512(q[word], _mm512_loadu_si512(&block[word])));
  };
  const auto distanceTo = [&](const Block& block) REVISIT_SLAM_EIGHT_WORDS {
    return _mm512_add_epi64(_mm512_add_epi64(differing(block, 0), differing(block, 1)),
                            _mm512_add_epi64(differing(block, 2), differing(block, 3)));
  };
  __m512i distances = _mm512_set1_epi64(best.distance), nearest = _mm512_setzero_si512();
  const auto take = [&](std::size_t b) REVISIT_SLAM_EIGHT_WORDS {
    const __m512i distance = distanceTo(blocks[b]);
    const __mmask8 is_nearer = _mm512_cmplt_epi64_mask(distance, distances);
    distances = _mm512_mask_mov_epi64(distances, is_nearer, distance);
    const __m512i number = _mm512_set1_epi64(static_cast<long long>(b));
    nearest = _mm512_mask_mov_epi64(nearest, is_nearer, number);
  };
  std::size_t b = 0;
  for (; b + 4 <= blocks.size(); b += 4) {
    const __m512i least =
        _mm512_min_epi64(_mm512_min_epi64(distanceTo(blocks[b]), distanceTo(blocks[b + 1])),
                         _mm512_min_epi64(distanceTo(blocks[b + 2]), distanceTo(blocks[b + 3])));
    if (_mm512_cmplt_epi64_mask(least, distances) == 0) continue;
    for (std::size_t i = b; i < b + 4; ++i) take(i);
  }
  for (; b < blocks.size(); ++b) take(b);
  std::array<std::int64_t, kLanes> lane_distances, lane_blocks;
  _mm512_storeu_si512(lane_distances.data(), distances);
  _mm512_storeu_si512(lane_blocks.data(), nearest);
  const int bound = best.distance;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const int distance = static_cast<int>(lane_distances[lane]);
    if (distance >= bound || distance > best.distance) continue;
    const std::size_t index = static_cast<std::size_t>(lane_blocks[lane]) * kLanes + lane;
    if (distance < best.distance || index < best.index) best = {index, distance};
  }
  return best;
}
#endif

std::vector<DescriptorSearch*> searchesHere() {
  std::vector<DescriptorSearch*> searches{searchAnywhere};
#ifdef REVISIT_SLAM_HAS_VERSIONS
  if (__builtin_cpu_supports("popcnt")) searches.push_back(searchByWord);
  if (__builtin_cpu_supports("avx512vpopcntdq")) searches.push_back(searchByEightWords);
#endif
  return searches;
}

}  // namespace

const std::vector<DescriptorSearch*>& descriptorSearches() {
  static const std::vector<DescriptorSearch*> searches = searchesHere();
  return searches;
}

DescriptorBlocks::DescriptorBlocks(const std::vector<Descriptor>& descriptors)
    : size_(descriptors.size()), blocks_((size_ + kLanes - 1) / kLanes) {
  for (std::size_t i = 0; i < size_; ++i) set(i, descriptors[i]);
}

void DescriptorBlocks::set(std::size_t index, const Descriptor& descriptor) {
  const std::size_t end = index + 1 < size_ ? index + 1 : kLanes * blocks_.size();
  for (std::size_t i = index; i < end; ++i)
    for (std::size_t word = 0; word < descriptor.size(); ++word)
      blocks_[i / kLanes][word][i % kLanes] = descriptor[word];
}

}  // namespace revisit_slam
