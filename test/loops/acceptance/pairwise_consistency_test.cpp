// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/pairwise_consistency.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

/// Pairs along two drives of 100 m whose common frame is wrong by one and the same `error`.
std::vector<RegisteredPair> consistentPairs(const Pose& error) {
  std::vector<RegisteredPair> pairs;
  for (int i = 0; i < 4; ++i) {
    const Pose T_target{expSO3({0, 0, 0.2 * i}), {25.0 * i, 0, 0}};
    const Pose T_source{expSO3({0, 0, 3.0 - 0.1 * i}), {25.0 * i, 5, 0}};
    pairs.push_back({T_target, T_source, T_target.inverse() * error * T_source, 0.5});
  }
  return pairs;
}

const Pose kError{expSO3({0, 0, 0.05}), {1.5, -1.0, 0.2}};

TEST(PairwiseConsistency, AcceptsPairsThatShareTheErrorOfTheGuess) {
  EXPECT_EQ(majority(consistentPairs(kError), 0, {}), std::vector<bool>(4, true));
}

TEST(PairwiseConsistency, DropsAPlantedWrongPair) {
  for (std::size_t wrong = 0; wrong < 4; ++wrong) {
    auto pairs = consistentPairs(kError);
    pairs[wrong].T_target_source =
        pairs[wrong].T_target_source * Pose{expSO3({0, 0, 0}), {5, 0, 0}};
    std::vector<bool> expected(4, true);
    expected[wrong] = false;
    EXPECT_EQ(majority(pairs, 0, {}), expected);
  }
}

TEST(PairwiseConsistency, DropsAPairThatIsTurned) {
  auto pairs = consistentPairs(kError);
  pairs[2].T_target_source.rotation = pairs[2].T_target_source.rotation * expSO3({0, 0.12, 0});
  EXPECT_EQ(majority(pairs, 0, {}), (std::vector<bool>{true, true, false, true}));
}

TEST(PairwiseConsistency, AllowsForDrift) {
  auto pairs = consistentPairs(kError);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    pairs[i].T_target_source =
        pairs[i].T_target_source *
        Pose{expSO3({0, 0, 0.002 * static_cast<double>(i)}), {0.2 * static_cast<double>(i), 0, 0}};
  EXPECT_EQ(majority(pairs, 0, {}), std::vector<bool>(4, true));
}

TEST(PairwiseConsistency, HalfIsNoMajorityAndOneIsWholly) {
  auto pairs = consistentPairs(kError);
  pairs.resize(2);
  pairs[1].T_target_source = pairs[1].T_target_source * Pose{expSO3({0, 0, 0}), {5, 0, 0}};
  EXPECT_EQ(majority(pairs, 0, {}), std::vector<bool>(2, false));
  pairs.resize(1);
  EXPECT_EQ(majority(pairs, 0, {}), std::vector<bool>(1, true));
  EXPECT_TRUE(majority({}, 0, {}).empty());
}

TEST(PairwiseConsistency, ThoseWithoutASayAreAmongAll) {
  auto pairs = consistentPairs(kError);
  EXPECT_EQ(majority(pairs, 3, {}), std::vector<bool>(4, true));
  EXPECT_EQ(majority(pairs, 4, {}), std::vector<bool>(4, false));
  pairs.resize(1);
  EXPECT_EQ(majority(pairs, 1, {}), std::vector<bool>(1, false));
}

}  // namespace
}  // namespace revisit_slam
