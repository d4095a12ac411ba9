// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/near_words.h"

#include <gtest/gtest.h>

#include <bitset>
#include <random>
#include <vector>

namespace revisit_slam {
namespace {

TEST(NearWords, AreFoundInOrder) {
  std::mt19937_64 random(1);
  std::vector<std::uint64_t> words;
  for (int i = 0; i < 500; ++i) words.push_back(random());
  words[7] = words[3] ^ 0x8000000000000001u;
  for (const int most : {0, 2, 32, 64}) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < words.size(); ++i)
      if (std::bitset<64>(words[i] ^ words[3]).count() <= static_cast<std::size_t>(most))
        expected.push_back(i);
    std::vector<std::uint32_t> near(words.size());
    near.resize(findNearWords(words[3], words.data(), words.size(), most, near.data()));
    EXPECT_EQ(near, expected) << most;
  }
}

TEST(NearWords, OfNoneThereAreNone) {
  EXPECT_EQ(findNearWords(1, nullptr, 0, 64, nullptr), 0u);
}

}  // namespace
}  // namespace revisit_slam
