// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_matching.h"

#include <gtest/gtest.h>

#include <random>

#include "revisit_slam/loops/recognition/place_nearest.h"

namespace revisit_slam {
namespace {

class PlaceMatching : public ::testing::Test {
 protected:
  std::vector<Descriptor> randomDescriptors(int count) {
    std::vector<Descriptor> descriptors(static_cast<std::size_t>(count));
    for (auto& descriptor : descriptors)
      for (auto& word : descriptor) word = random_();
    return descriptors;
  }

  /// With this many other bits flipped.
  Descriptor changed(Descriptor descriptor, int bits) {
    const Descriptor original = descriptor;
    while (differingBits(original, descriptor) < bits)
      descriptor[random_() % 4] ^= std::uint64_t{1} << random_() % 64;
    return descriptor;
  }

  std::mt19937_64 random_{5};
};

TEST_F(PlaceMatching, FindsTheFirstNearestAsACompleteSearchDoes) {
  for (const std::size_t count : {0, 1, 3, 5, 8, 9, 64, 499}) {
    auto descriptors = randomDescriptors(static_cast<int>(count));
    const Descriptor query = randomDescriptors(1)[0];
    if (count > 4) descriptors[count - 1] = descriptors[2] = changed(query, 30);
    for (const int bound : {20, 31, 110, 257}) {
      NearestDescriptor expected{count, bound};
      for (std::size_t i = 0; i < count; ++i) {
        const int distance = differingBits(query, descriptors[i]);
        if (distance < expected.distance) expected = {i, distance};
      }
      for (DescriptorSearch* search : descriptorSearches()) {
        const NearestDescriptor found = DescriptorBlocks(descriptors).nearest(query, bound, search);
        EXPECT_EQ(found.index, expected.index);
        EXPECT_EQ(found.distance, expected.distance);
      }
    }
  }
}

TEST_F(PlaceMatching, TakesTheNearestUpToTheLimit) {
  const auto target = randomDescriptors(100);
  const std::vector<Descriptor> source{changed(target[7], 50), changed(target[8], 51),
                                       changed(target[9], 0)};
  const auto matches = matchFeatures(source, DescriptorBlocks(target), 50);
  ASSERT_EQ(matches.size(), 2u);
  EXPECT_EQ(matches[0].source, 0);
  EXPECT_EQ(matches[0].target, 7);
  EXPECT_EQ(matches[1].source, 2);
  EXPECT_EQ(matches[1].target, 9);
}

TEST_F(PlaceMatching, KnowsWhatIsRepeated) {
  auto descriptors = randomDescriptors(10);
  descriptors.push_back(changed(descriptors[3], 35));
  descriptors.push_back(changed(descriptors[5], 36));
  const auto repeated = repeatedDescriptors(descriptors, 35);
  for (std::size_t i = 0; i < descriptors.size(); ++i) EXPECT_EQ(repeated[i], i == 3 || i == 10);
}

}  // namespace
}  // namespace revisit_slam
