// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/gate.h"

#include <gtest/gtest.h>

#include <limits>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

std::vector<RegisteredPair> pairsOfFitness(const std::vector<double>& values) {
  std::vector<RegisteredPair> pairs(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) pairs[i].registration.fitness = values[i];
  return pairs;
}

Gate fitnessAbove(const std::string& name, double limit) {
  return gateOfEach(name, [limit](const RegisteredPair& pair) {
    return GateMeasurement{pair.registration.fitness, Bound::above, limit, ""};
  });
}

std::vector<std::string> outcomes(const std::vector<double>& fitness,
                                  const std::vector<Gate>& gates) {
  std::vector<std::string> names;
  for (const LoopVerdict& verdict : judge(pairsOfFitness(fitness), gates))
    names.push_back(verdict.outcome());
  return names;
}

TEST(GateMeasurement, BoundsContainTheirLimitOrNot) {
  EXPECT_FALSE((GateMeasurement{1.0, Bound::above, 1.0, ""}.isWithin()));
  EXPECT_TRUE((GateMeasurement{1.1, Bound::above, 1.0, ""}.isWithin()));
  EXPECT_TRUE((GateMeasurement{1.0, Bound::at_least, 1.0, ""}.isWithin()));
  EXPECT_FALSE((GateMeasurement{0.9, Bound::at_least, 1.0, ""}.isWithin()));
  EXPECT_TRUE((GateMeasurement{1.0, Bound::at_most, 1.0, ""}.isWithin()));
  EXPECT_FALSE((GateMeasurement{1.1, Bound::at_most, 1.0, ""}.isWithin()));
  for (const Bound bound : {Bound::above, Bound::at_least, Bound::at_most})
    EXPECT_FALSE(
        (GateMeasurement{std::numeric_limits<double>::quiet_NaN(), bound, 1.0, ""}.isWithin()));
}

TEST(LoopVerdict, SaysTheNumberAndTheLimit) {
  EXPECT_EQ((LoopVerdict{"fitness", {0.18, Bound::above, 0.25, ""}}.reason()),
            "fitness 0.18 <= 0.25");
  EXPECT_EQ((LoopVerdict{"coherence", {0.4, Bound::at_least, 0.5, ""}}.reason()),
            "coherence 0.4 < 0.5");
  EXPECT_EQ((LoopVerdict{"translation", {7.254, Bound::at_most, 6.0, "m"}}.reason()),
            "translation 7.254 m > 6 m");
  EXPECT_EQ(LoopVerdict().reason(), "");
  EXPECT_EQ(LoopVerdict().outcome(), "accepted");
}

TEST(Judge, NamesTheFirstGateThatRejects) {
  EXPECT_EQ(outcomes({0.1, 0.3, 0.5}, {fitnessAbove("low", 0.2), fitnessAbove("high", 0.4)}),
            (std::vector<std::string>{"low", "high", "accepted"}));
  EXPECT_EQ(outcomes({0.1}, {}), std::vector<std::string>{"accepted"});
  const auto verdicts = judge(pairsOfFitness({0.1}), {fitnessAbove("low", 0.2)});
  EXPECT_EQ(verdicts[0].measurement.value, 0.1);
  EXPECT_EQ(verdicts[0].measurement.limit, 0.2);
}

TEST(Judge, AGateForLonePairsLooksAtTheLastOneThatRemains) {
  const Gate lone = onlyLone(fitnessAbove("fitness", 0.4));
  EXPECT_EQ(outcomes({0.3, 0.3}, {lone}), std::vector<std::string>(2, "accepted"));
  EXPECT_EQ(outcomes({0.3}, {lone}), std::vector<std::string>{"lone fitness"});
  EXPECT_EQ(outcomes({0.1, 0.3}, {fitnessAbove("low", 0.2), lone}),
            (std::vector<std::string>{"low", "lone fitness"}));
}

TEST(Judge, AGateSeesWhatRemainsAndHowManyWereRejectedBefore) {
  RemainingPairs seen;
  const Gate spy{
      "spy", [&seen](const RemainingPairs& remaining) {
        seen = remaining;
        return std::vector<GateMeasurement>(remaining.pairs.size(), {1.0, Bound::above, 0.0, ""});
      }};
  outcomes({0.1, 0.3, 0.1}, {fitnessAbove("low", 0.2), spy});
  ASSERT_EQ(seen.pairs.size(), 1u);
  EXPECT_EQ(seen.pairs[0].registration.fitness, 0.3);
  EXPECT_EQ(seen.rejected, (std::map<std::string, std::size_t>{{"low", 2}}));
}

TEST(RegisteredPair, MovedFromItsGuess) {
  RegisteredPair pair;
  pair.T_common_target = {expSO3({0, 0, 1.0}), {10, 0, 0}};
  pair.T_common_source = {expSO3({0, 0, 0.5}), {12, 3, 0}};
  const Pose moved{expSO3({0, 0, 0.1}), {0.3, 0.4, 0}};
  pair.registration.T_target_source = pair.T_common_target.inverse() * pair.T_common_source * moved;
  EXPECT_NEAR(pair.movedTranslation(), 0.5, 1e-12);
  EXPECT_NEAR(pair.movedRotation(), 0.1 * 180.0 / M_PI, 1e-9);
}

}  // namespace
}  // namespace revisit_slam
