// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/registration.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/room_map.h"
#include "support/threads.h"

namespace revisit_slam {
namespace {

constexpr double kSigma = 0.5;

TEST(Registration, RecoversAKnownPerturbation) {
  const LocalVoxelMap map = mapOfRoom(0.0);
  RandomNumbers random(2);
  for (const auto& [half_translation, angle] : {std::pair{0.05, 0.005}, {0.3, 0.02}, {0.5, 0.05}}) {
    const Pose truth = exp(random.tangent(2.0, 0.5));
    const Points source = seenFrom(truth, everyFifth(map.points()));
    const Pose initial = boxplus(truth, random.tangent(half_translation, angle));
    const auto result = Registration({}).align(source, {}, map, initial, kSigma);
    EXPECT_EQ(result.outcome, RegistrationOutcome::converged);
    EXPECT_LT(distanceBetween(truth, result.T_odom_base), 1e-3) << angle;
    EXPECT_GT(distanceBetween(truth, initial), 20 * distanceBetween(truth, result.T_odom_base));
    EXPECT_EQ(result.correspondences, source.size());
    EXPECT_LT(result.rms_residual, 1e-3);
  }
}

TEST(Registration, AlignsOtherNoisySamplesOfTheRoom) {
  const LocalVoxelMap map = mapOfRoom(0.02);
  RandomNumbers random(3);
  const Pose truth = exp(random.tangent(1.0, 0.3));
  const Points seen = SyntheticRoom().sample(truth.translation, 4000, 0.02, random);
  const Pose initial = boxplus(truth, random.tangent(0.2, 0.02));
  const auto result = Registration({}).align(seenFrom(truth, seen), {}, map, initial, kSigma);
  EXPECT_EQ(result.outcome, RegistrationOutcome::converged);
  const Tangent error = log(truth.inverse() * result.T_odom_base);
  EXPECT_LT(error.head<3>().norm(), 0.02);
  EXPECT_LT(error.tail<3>().norm(), 0.002);
}

/// A screen that is new to the map and nearer than any wall: its points match the wall behind.
Points screenBefore(const Points& wall_points, float ahead) {
  Points screen;
  for (const Eigen::Vector3f& p : wall_points) screen.push_back(p * (1.0f - ahead / p.norm()));
  return screen;
}

TEST(Registration, WhatIsNewToTheMapDoesNotPullOnceTheToleranceIsFine) {
  const LocalVoxelMap map = mapOfRoom(0.0);
  const Points known = everyFifth(map.points());
  Points seen = known;
  for (const Eigen::Vector3f& p : screenBefore(known, 0.8f))
    if (p.x() > 0.0f) seen.push_back(p);
  const Pose truth = exp(RandomNumbers(7).tangent(0.2, 0.02));
  const auto errorWith = [&](double final_sigma) {
    RegistrationConfig config;
    config.final_sigma = final_sigma;
    const auto result =
        Registration(config).align(seenFrom(truth, seen), {}, map, Pose::identity(), 2.0);
    EXPECT_EQ(result.outcome, RegistrationOutcome::converged);
    return distanceBetween(truth, result.T_odom_base);
  };
  EXPECT_LT(errorWith(0.1), 0.2 * errorWith(100.0));
}

TEST(Registration, WhereAFineToleranceLeavesTooFewMatchesTheCoarserResultStands) {
  const LocalVoxelMap map = mapOfRoom(0.0);
  Points apart;
  for (const Eigen::Vector3f& p : everyFifth(map.points()))
    if (apart.size() < 12) apart.push_back(p * (apart.size() % 2 ? 0.9f : 1.1f));
  const Pose initial = exp(RandomNumbers(8).tangent(0.1, 0.01));
  RegistrationConfig config;
  config.final_sigma = 0.01;
  const auto result = Registration(config).align(apart, {}, map, initial, 2.0);
  EXPECT_EQ(result.outcome, RegistrationOutcome::converged);
  EXPECT_LT(result.correspondences, 10u);
  EXPECT_NE(result.T_odom_base.matrix(), initial.matrix());
}

TEST(Registration, GivesTheSameBitsForAnyNumberOfThreads) {
  const LocalVoxelMap map = mapOfRoom(0.02);
  const Points source = everyFifth(map.points());
  const Pose initial = exp(RandomNumbers(5).tangent(0.3, 0.03));
  const auto on = [&](int threads) {
    return onThreads(threads, [&] {
      return Registration({}).align(source, {}, map, initial, kSigma).T_odom_base.matrix();
    });
  };
  const Eigen::Matrix4d one = on(1);
  EXPECT_NE(one, initial.matrix());
  for (const int threads : {2, 4, 4, 3}) EXPECT_EQ(on(threads), one) << threads;
}

TEST(Registration, StaysAtThePredictionWithoutMapOrCorrespondences) {
  const Pose initial = exp(RandomNumbers(6).tangent(3.0, 1.0));
  const Points few(9, {0, 0, 0}), many(20, {0, 0, 0});
  LocalVoxelMap map({1.0, 20});
  auto result = Registration({}).align(many, {}, map, initial, kSigma);
  EXPECT_EQ(result.outcome, RegistrationOutcome::map_empty);
  EXPECT_EQ(result.T_odom_base.matrix(), initial.matrix());
  map.insert({{0.1f, 0, 0}}, initial);
  result = Registration({}).align(few, {}, map, initial, kSigma);
  EXPECT_EQ(result.outcome, RegistrationOutcome::too_few_correspondences);
  EXPECT_EQ(result.correspondences, 9u);
  EXPECT_EQ(result.T_odom_base.matrix(), initial.matrix());
  const Pose far_away{initial.rotation, initial.translation + Eigen::Vector3d(0, 0, 1.8)};
  EXPECT_EQ(Registration({}).align(many, {}, map, far_away, kSigma).outcome,
            RegistrationOutcome::too_few_correspondences);
}

TEST(Registration, StopsAtTheLargestNumberOfIterations) {
  const LocalVoxelMap map = mapOfRoom(0.0);
  const Points source = everyFifth(map.points());
  const Pose initial = exp(RandomNumbers(7).tangent(0.3, 0.03));
  const RegistrationConfig config{2, 1e-4, 10};
  const auto result = Registration(config).align(source, {}, map, initial, kSigma);
  EXPECT_EQ(result.outcome, RegistrationOutcome::max_iterations);
  EXPECT_EQ(result.iterations, 2);
  EXPECT_LT(distanceBetween(result.T_odom_base, {}), distanceBetween(initial, {}));
}

TEST(Registration, AStepThatIsNotFiniteEndsAtThePrediction) {
  const LocalVoxelMap map = mapOfRoom(0.0);
  PosePrediction predicted(exp(RandomNumbers(9).tangent(0.1, 0.01)));
  predicted.information = Matrix6::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto result = Registration({}).align(everyFifth(map.points()), {}, map, predicted, kSigma);
  EXPECT_NE(result.outcome, RegistrationOutcome::converged);
  EXPECT_EQ(result.T_odom_base.matrix(), predicted.T_odom_base.matrix());
  EXPECT_EQ(result.information, Matrix6::Zero());
}

}  // namespace
}  // namespace revisit_slam
