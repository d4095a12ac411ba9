// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/place_nearest.h"

#if defined(__x86_64__) && defined(__GNUC__)
#define REVISIT_SLAM_HAS_VERSIONS
#include <immintrin.h>
#pragma GCC diagnostic ignored "-Wuninitialized"  // within that header (GCC bug 105593)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace revisit_slam {
namespace {

/// Stopping after half of the bits would not pay: a third of all pairs is still within the bound.
inline __attribute__((always_inline)) void search(const Descriptor& query,
                                                  const Descriptor* descriptors, std::size_t begin,
                                                  std::size_t end, NearestDescriptor& best) {
  for (std::size_t i = begin; i < end; ++i) {
    const int distance = differingBits(query, descriptors[i]);
    if (distance < best.distance) best = {i, distance};
  }
}

using Search = void(const Descriptor&, const Descriptor*, std::size_t, std::size_t,
                    NearestDescriptor&);

void searchAnywhere(const Descriptor& query, const Descriptor* descriptors, std::size_t begin,
                    std::size_t end, NearestDescriptor& best) {
  search(query, descriptors, begin, end, best);
}

#ifdef REVISIT_SLAM_HAS_VERSIONS
/// With the instruction that counts the bits of one word.
__attribute__((target("popcnt"))) void searchByWord(const Descriptor& query,
                                                    const Descriptor* descriptors,
                                                    std::size_t begin, std::size_t end,
                                                    NearestDescriptor& best) {
  search(query, descriptors, begin, end, best);
}

/// With the instruction that counts those of eight: four descriptors at a time are compared with
/// the bound, and one by one where any of them is nearer.
__attribute__((target("popcnt,avx512f,avx512vpopcntdq"))) void searchByEightWords(
    const Descriptor& query, const Descriptor* descriptors, std::size_t begin, std::size_t end,
    NearestDescriptor& best) {
  const __m512i q =
      _mm512_broadcast_i64x4(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(query.data())));
  std::size_t i = begin;
  for (; i + 4 <= end; i += 4) {
    const __m512i a = _mm512_popcnt_epi64(_mm512_xor_si512(q, _mm512_loadu_si512(descriptors + i)));
    const __m512i b =
        _mm512_popcnt_epi64(_mm512_xor_si512(q, _mm512_loadu_si512(descriptors + i + 2)));
    const __m512i halves =
        _mm512_add_epi64(_mm512_unpacklo_epi64(a, b), _mm512_unpackhi_epi64(a, b));
    const __m512i sums = _mm512_add_epi64(halves, _mm512_shuffle_i64x2(halves, halves, 0xB1));
    if (_mm512_cmplt_epi64_mask(sums, _mm512_set1_epi64(best.distance)))
      search(query, descriptors, i, i + 4, best);
  }
  search(query, descriptors, i, end, best);
}
#endif

Search* fastestSearch() {
#ifdef REVISIT_SLAM_HAS_VERSIONS
  if (__builtin_cpu_supports("avx512vpopcntdq")) return searchByEightWords;
  if (__builtin_cpu_supports("popcnt")) return searchByWord;
#endif
  return searchAnywhere;
}

}  // namespace

NearestDescriptor nearestDescriptor(const Descriptor& query, const Descriptor* descriptors,
                                    std::size_t begin, std::size_t end, int bound) {
  static Search* const search_fast = fastestSearch();
  NearestDescriptor best{end, bound};
  search_fast(query, descriptors, begin, end, best);
  return best;
}

}  // namespace revisit_slam
