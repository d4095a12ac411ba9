// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/nearest_distances.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cmath>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

NearestDistances bruteForce(const Points& a, const Points& b, float limit) {
  NearestDistances result;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Eigen::Vector3f& p : *from) {
      float best = limit * limit;
      for (const Eigen::Vector3f& q : *to) best = std::min(best, (q - p).squaredNorm());
      ++result.points;
      if (best >= limit * limit) continue;
      ++result.paired;
      result.squared_sum += best;
    }
  return result;
}

TEST(NearestDistances, AreThoseOfBruteForce) {
  RandomNumbers random(1);
  const Points a = random.cloud(1500, 8.0), b = random.cloud(2500, 7.0);
  for (const float limit : {0.3f, 1.0f, 2.5f}) {
    const NearestDistances fast = nearestDistances(a, b, limit), slow = bruteForce(a, b, limit);
    EXPECT_EQ(fast.points, 4000u);
    EXPECT_EQ(fast.paired, slow.paired);
    EXPECT_NEAR(fast.squared_sum, slow.squared_sum, 1e-6 * slow.squared_sum);
    EXPECT_GT(fast.paired, 0u);
  }
}

TEST(NearestDistances, OfTwoPointsAreCountedFromBothSides) {
  const NearestDistances distances =
      nearestDistances({{0, 0, 0}, {9, 0, 0}}, {{0.3f, 0.4f, 0}}, 1.0);
  EXPECT_EQ(distances.points, 3u);
  EXPECT_EQ(distances.paired, 2u);
  EXPECT_NEAR(distances.rms(), 0.5, 1e-7);
  EXPECT_NEAR(distances.share(), 2.0 / 3.0, 1e-12);
}

TEST(NearestDistances, OfNothingAreUnknown) {
  EXPECT_TRUE(std::isnan(nearestDistances({}, {}, 1.0).share()));
  EXPECT_TRUE(std::isnan(nearestDistances({{0, 0, 0}}, {{5, 0, 0}}, 1.0).rms()));
}

TEST(NearestDistances, AreTheSameBitsForAnyNumberOfThreads) {
  RandomNumbers random(2);
  const Points a = random.cloud(9000, 8.0), b = random.cloud(9000, 8.0);
  const auto with = [&](int threads) {
    NearestDistances result;
    tbb::task_arena(threads).execute([&] { result = nearestDistances(a, b, 1.0); });
    return result.squared_sum;
  };
  EXPECT_EQ(with(1), with(4));
}

}  // namespace
}  // namespace revisit_slam
