// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/association/hausdorff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

using Positions = std::vector<Eigen::Vector3d>;

Positions randomWalk(std::size_t count, double step, RandomNumbers& random) {
  Positions positions{random.inCube(30.0)};
  Eigen::Vector3d direction = random.direction();
  while (positions.size() < count) {
    direction = (direction + 0.3 * random.direction()).normalized();
    positions.push_back(positions.back() + random.uniform(0.0, step) * direction);
  }
  return positions;
}

double nearest(const Eigen::Vector3d& p, const Positions& positions) {
  double best = kAnyDistance;
  for (const Eigen::Vector3d& q : positions) best = std::min(best, (p - q).norm());
  return best;
}

double bruteForce(const Positions& a, const Positions& b) {
  double largest = 0.0;
  for (const Eigen::Vector3d& p : a) largest = std::max(largest, nearest(p, b));
  for (const Eigen::Vector3d& p : b) largest = std::max(largest, nearest(p, a));
  return largest;
}

TEST(Hausdorff, EqualsBruteForce) {
  RandomNumbers random(11);
  for (int round = 0; round < 300; ++round) {
    const Positions a = randomWalk(1 + round % 80, 3.0, random);
    const Positions b = randomWalk(1 + round % 57, 1.0, random);
    const double expected = bruteForce(a, b);
    EXPECT_DOUBLE_EQ(hausdorffDistance(Path(a), Path(b)), expected);
    EXPECT_DOUBLE_EQ(hausdorffDistance(Path(a), Path(b), expected * 1.001), expected);
    EXPECT_EQ(hausdorffDistance(Path(a), Path(b), expected * 0.999), kAnyDistance);
  }
}

TEST(Hausdorff, DoesNotSeeTheDirectionOfTravel) {
  RandomNumbers random(12);
  const Positions a = randomWalk(60, 2.0, random);
  Positions reversed = a;
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(hausdorffDistance(Path(a), Path(reversed)), 0.0);
}

TEST(Hausdorff, OfNothingIsInfinite) {
  EXPECT_EQ(hausdorffDistance(Path(), Path({Eigen::Vector3d::Zero()})), kAnyDistance);
  EXPECT_FALSE(comeWithin(Path(), Path({Eigen::Vector3d::Zero()}), 1e9));
}

TEST(Hausdorff, ComeWithinEqualsBruteForce) {
  RandomNumbers random(13);
  for (int round = 0; round < 200; ++round) {
    const Positions a = randomWalk(40, 2.0, random), b = randomWalk(50, 2.0, random);
    double gap = kAnyDistance;
    for (const Eigen::Vector3d& p : a) gap = std::min(gap, nearest(p, b));
    EXPECT_TRUE(comeWithin(Path(a), Path(b), gap * 1.0001));
    EXPECT_FALSE(comeWithin(Path(a), Path(b), gap * 0.9999));
  }
}

}  // namespace
}  // namespace revisit_slam
