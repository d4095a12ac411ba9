// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/search/tried_pairs.h"

#include <gtest/gtest.h>

#include <limits>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

Pose moved(const Pose& T, double x, double yaw) {
  return T * exp((Tangent() << x, 0.0, 0.0, 0.0, 0.0, yaw).finished());
}

TEST(TriedPairs, AreTriedUntilTheGraphSaysSomethingElse) {
  const Pose T = moved(Pose::identity(), 30.0, 2.0);
  const PairGuess guess{T, T, 5.0};
  TriedPairs tried;
  const LocalMapPair pair{LocalMapId{5}, LocalMapId{1}};
  const auto isForgotten = [&](const PairGuess& now) {
    tried.note(pair, guess);
    tried.forgetChanged([&](const LocalMapPair&) { return now; });
    return !tried.has(pair);
  };
  EXPECT_FALSE(isForgotten(guess));
  EXPECT_FALSE(isForgotten({moved(T, 0.05, 0.001), moved(T, -0.05, 0.001), 4.9}));
  EXPECT_TRUE(isForgotten({moved(T, 0.2, 0.0), T, 5.0}));
  EXPECT_TRUE(isForgotten({moved(T, 0.0, 0.01), T, 5.0}));
  EXPECT_TRUE(isForgotten({T, moved(T, 0.2, 0.0), 5.0}));
  EXPECT_TRUE(isForgotten({T, T, 4.0}));
  EXPECT_TRUE(isForgotten({T, T, std::numeric_limits<double>::infinity()}));
}

TEST(TriedPairs, AreKnownAsLongAsTheirDriftIsUnknown) {
  TriedPairs tried;
  const LocalMapPair pair{LocalMapId{5}, LocalMapId{1}};
  const PairGuess guess{{}, {}, std::numeric_limits<double>::infinity()};
  tried.note(pair, guess);
  tried.forgetChanged([&](const LocalMapPair&) { return guess; });
  EXPECT_TRUE(tried.has(pair));
  tried.forgetChanged([](const LocalMapPair&) { return PairGuess{{}, {}, 5.0}; });
  EXPECT_FALSE(tried.has(pair));
}

}  // namespace
}  // namespace revisit_slam
