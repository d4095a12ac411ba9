// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/pairwise_consistency.h"

#include <gtest/gtest.h>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

/// Pairs along two drives of 100 m whose common frame is wrong by one and the same `error`.
std::vector<RegisteredPair> consistentPairs(const Pose& error) {
  std::vector<RegisteredPair> pairs;
  for (int i = 0; i < 4; ++i) {
    RegisteredPair pair;
    pair.T_common_target = {expSO3({0, 0, 0.2 * i}), {25.0 * i, 0, 0}};
    pair.T_common_source = {expSO3({0, 0, 3.0 - 0.1 * i}), {25.0 * i, 5, 0}};
    pair.registration.T_target_source =
        pair.T_common_target.inverse() * error * pair.T_common_source;
    pair.registration.fitness = 0.5;
    pairs.push_back(pair);
  }
  return pairs;
}

const Pose kError{expSO3({0, 0, 0.05}), {1.5, -1.0, 0.2}};

void displace(RegisteredPair& pair, double metres) {
  Pose& T = pair.registration.T_target_source;
  T = T * Pose{Eigen::Quaterniond::Identity(), {metres, 0, 0}};
}

std::vector<GateMeasurement> measure(const std::vector<RegisteredPair>& pairs,
                                     const PairwiseConsistencyConfig& config = {}) {
  return consistencyGate(config, {}).measure({pairs, {}});
}

std::vector<bool> majority(const std::vector<RegisteredPair>& pairs, std::size_t opponents = 0) {
  std::vector<bool> belongs;
  for (const GateMeasurement& measurement :
       consistencyGate({}, {"coherence"}).measure({pairs, {{"coherence", opponents}}}))
    belongs.push_back(measurement.isWithin());
  return belongs;
}

TEST(PairwiseConsistency, AcceptsPairsThatShareTheErrorOfTheGuess) {
  EXPECT_EQ(majority(consistentPairs(kError)), std::vector<bool>(4, true));
}

TEST(PairwiseConsistency, DropsAPlantedWrongPair) {
  for (std::size_t wrong = 0; wrong < 4; ++wrong) {
    auto pairs = consistentPairs(kError);
    displace(pairs[wrong], 5.0);
    std::vector<bool> expected(4, true);
    expected[wrong] = false;
    EXPECT_EQ(majority(pairs), expected);
  }
}

TEST(PairwiseConsistency, DropsAPairThatIsTurned) {
  auto pairs = consistentPairs(kError);
  Eigen::Quaterniond& rotation = pairs[2].registration.T_target_source.rotation;
  rotation = rotation * expSO3({0, 0.12, 0});
  EXPECT_EQ(majority(pairs), (std::vector<bool>{true, true, false, true}));
  EXPECT_EQ(measure(pairs)[2].unit, "deg");
  EXPECT_NEAR(measure(pairs)[2].value, 0.12 * 180.0 / M_PI, 1e-6);
}

TEST(PairwiseConsistency, AllowsForDriftUnlessTheGraphPlacedTheSubmaps) {
  auto pairs = consistentPairs(kError);
  for (std::size_t i = 0; i < pairs.size(); ++i) displace(pairs[i], 0.2 * static_cast<double>(i));
  EXPECT_EQ(majority(pairs), std::vector<bool>(4, true));
  const auto without_drift = measure(pairs, PairwiseConsistencyConfig().withoutDrift());
  EXPECT_TRUE(without_drift[2].isWithin());
  EXPECT_FALSE(without_drift[3].isWithin());
  EXPECT_NEAR(without_drift[3].value, 0.4, 0.02);  // from that in the middle
  EXPECT_EQ(without_drift[3].limit, 0.3);
}

TEST(PairwiseConsistency, HalfIsNoMajorityAndOneIsWholly) {
  auto pairs = consistentPairs(kError);
  pairs.resize(2);
  displace(pairs[1], 5.0);
  EXPECT_EQ(majority(pairs), std::vector<bool>(2, false));
  EXPECT_EQ(measure(pairs)[0].value, 0.5);
  pairs.resize(1);
  EXPECT_EQ(majority(pairs), std::vector<bool>(1, true));
  EXPECT_TRUE(majority({}).empty());
}

TEST(PairwiseConsistency, OpponentsAreAmongAll) {
  auto pairs = consistentPairs(kError);
  EXPECT_EQ(majority(pairs, 3), std::vector<bool>(4, true));
  EXPECT_EQ(majority(pairs, 4), std::vector<bool>(4, false));
  pairs.resize(1);
  EXPECT_EQ(majority(pairs, 1), std::vector<bool>(1, false));
  const Gate without_opponents = consistencyGate({}, {});
  EXPECT_TRUE(without_opponents.measure({pairs, {{"coherence", 1}}})[0].isWithin());
}

}  // namespace
}  // namespace revisit_slam
