// SPDX-License-Identifier: MIT
// Scans that were deskewed with a motion that turned out to be another.
#include <gtest/gtest.h>

#include "revisit_slam/odometry/registration.h"
#include "support/room_map.h"
#include "support/threads.h"

namespace revisit_slam {
namespace {

constexpr double kSigma = 0.5;

/// Points of the world as a base sees them that goes on from T_odom_predicted by `missed`, deskewed as
/// if it did not.
struct BentScan {
  Pose T_odom_predicted, T_odom_base;
  Points points_base;
  std::vector<float> lags;
};

BentScan bentScan(const Points& points_odom, const Pose& T_odom_base, const Tangent& missed) {
  BentScan scan{T_odom_base * exp(-missed), T_odom_base, {}, {}};
  RandomNumbers random(8);
  for (const Eigen::Vector3f& p : points_odom) {
    scan.lags.push_back(static_cast<float>(random.uniform(0.0, 1.0)));
    const Pose T_odom_then = T_odom_base * exp(-scan.lags.back() * missed);
    scan.points_base.push_back((T_odom_then.inverse() * p.cast<double>()).cast<float>());
  }
  return scan;
}

RegistrationResult align(const BentScan& scan, const LocalVoxelMap& map,
                         const RegistrationConfig& config) {
  return Registration(config).align(scan.points_base, scan.lags, map, scan.T_odom_predicted, kSigma);
}

Tangent jolt() {
  Tangent missed;
  missed << 0.1, -0.06, 0.05, 0.01, 0.03, -0.02;
  return missed;
}

TEST(RegistrationOfABentScan, KeepsHalfOfTheErrorThatThePredictionLeaves) {
  const LocalVoxelMap map = mapOfRoom(0.0);
  const BentScan scan = bentScan(everyFifth(map.points()), {}, jolt());
  RegistrationConfig with, without;
  with.held_weight = with.prediction_weight = without.prediction_weight = 0.0;
  without.own_motion = 0.0;
  const RegistrationResult bent = align(scan, map, with), rigid = align(scan, map, without);
  EXPECT_EQ(bent.outcome, RegistrationOutcome::converged);
  EXPECT_LT(bent.iterations, 3 * rigid.iterations);
  EXPECT_EQ(rigid.bend, Tangent::Zero());
  const Tangent rigid_error = log(scan.T_odom_base.inverse() * rigid.T_odom_base);
  const Tangent bent_error = log(scan.T_odom_base.inverse() * bent.T_odom_base);
  // -lag (1 - k) / (1 - k lag) of what was missed, with the mean lag of a half
  EXPECT_LT((rigid_error + 0.5 * jolt()).norm(), 0.15 * jolt().norm());
  EXPECT_LT((bent_error + 0.25 * jolt()).norm(), 0.15 * jolt().norm());
  const Tangent deviation = log(scan.T_odom_predicted.inverse() * bent.T_odom_base);
  EXPECT_LT((bent.bend - with.own_motion * deviation).norm(), 0.15 * deviation.norm());
}

/// On a plane of which other points are seen nothing tells the way along it.
TEST(RegistrationOfABentScan, TakesNothingFromDirectionsThatAreNotHeld) {
  RandomNumbers random(9);
  const auto floor = [&](std::size_t count) {
    Points points = random.cloud(count, 15.0);
    for (Eigen::Vector3f& p : points) p.z() = 0.0f;
    return points;
  };
  LocalVoxelMap map({0.5, 20});
  map.insert(floor(60000), {});
  const RegistrationResult result =
      align(bentScan(floor(3000), {{1, 0, 0, 0}, {0, 0, 0.5}}, jolt()), map, {});
  const Tangent missed = jolt();
  EXPECT_NEAR(result.bend.z() / missed.z(), 0.5, 0.1);  // own_motion of the 3/4 that came out
  EXPECT_NEAR(result.bend[4] / missed[4], 0.5, 0.1);
  for (const int along : {0, 1, 5}) EXPECT_LT(std::abs(result.bend[along] / missed[along]), 0.02);
}

TEST(RegistrationOfABentScan, GivesTheSameBitsForAnyNumberOfThreads) {
  const LocalVoxelMap map = mapOfRoom(0.02);
  const BentScan scan = bentScan(everyFifth(map.points()), {}, jolt());
  const auto on = [&](int threads) {
    return onThreads(threads, [&] {
      const RegistrationResult result = align(scan, map, {});
      return std::pair(result.T_odom_base.matrix(), result.bend);
    });
  };
  const auto one = on(1);
  for (const int threads : {2, 4, 3}) EXPECT_EQ(on(threads), one) << threads;
}

TEST(RegistrationOfABentScan, WithoutCorrespondencesStaysAtThePrediction) {
  const LocalVoxelMap map = mapOfRoom(0.0);
  BentScan scan = bentScan(everyFifth(map.points()), {}, jolt());
  scan.T_odom_predicted.translation.x() = 500.0;
  const RegistrationResult result = align(scan, map, {});
  EXPECT_EQ(result.outcome, RegistrationOutcome::too_few_correspondences);
  EXPECT_EQ(result.T_odom_base.matrix(), scan.T_odom_predicted.matrix());
  EXPECT_EQ(result.bend, Tangent::Zero());
}

}  // namespace
}  // namespace revisit_slam
