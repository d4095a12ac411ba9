// SPDX-License-Identifier: MIT
// Scans that were deskewed with a motion that turned out to be another.
#include "revisit_slam/odometry/deskew_correction.h"

#include <gtest/gtest.h>

#include "revisit_slam/odometry/registration.h"
#include "support/room_map.h"
#include "support/threads.h"

namespace revisit_slam {
namespace {

constexpr double kSigma = 0.5;

/// Points of the world as a base sees them that goes on from T_odom_predicted by `missed`, deskewed
/// as if it did not.
struct WronglyDeskewedScan {
  Pose T_odom_predicted, T_odom_base;
  Points points_base;
  std::vector<float> sweep_fractions;
};

WronglyDeskewedScan wronglyDeskewedScan(const Points& points_odom, const Pose& T_odom_base,
                                        const Tangent& missed) {
  WronglyDeskewedScan scan{T_odom_base * exp(-missed), T_odom_base, {}, {}};
  RandomNumbers random(8);
  for (const Eigen::Vector3f& p : points_odom) {
    scan.sweep_fractions.push_back(static_cast<float>(random.uniform(0.0, 1.0)));
    const Pose T_odom_then = T_odom_base * exp(-scan.sweep_fractions.back() * missed);
    scan.points_base.push_back((T_odom_then.inverse() * p.cast<double>()).cast<float>());
  }
  return scan;
}

RegistrationResult align(const WronglyDeskewedScan& scan, const LocalVoxelMap& map,
                         const RegistrationConfig& config) {
  return Registration(config).align(scan.points_base, scan.sweep_fractions, map,
                                    scan.T_odom_predicted, kSigma);
}

Tangent jolt() {
  Tangent missed;
  missed << 0.1, -0.06, 0.05, 0.01, 0.03, -0.02;
  return missed;
}

TEST(DeskewCorrection, AppliedItUndoesWhatTheDeskewingMissed) {
  const Pose T_odom_base = exp(RandomNumbers(7).tangent(2.0, 0.5));
  const Points points_odom = RandomNumbers(7).cloud(20000, 40.0);
  WronglyDeskewedScan scan = wronglyDeskewedScan(points_odom, T_odom_base, jolt());
  const auto largestError = [&] {
    double largest = 0.0;
    for (std::size_t i = 0; i < points_odom.size(); ++i) {
      const Eigen::Vector3d p_odom = T_odom_base * scan.points_base[i].cast<double>();
      largest = std::max(largest, (p_odom - points_odom[i].cast<double>()).norm());
    }
    return largest;
  };
  EXPECT_GT(largestError(), 1.0);
  applyDeskewCorrection(scan.points_base, scan.sweep_fractions, jolt());
  EXPECT_LT(largestError(), 0.02);
}

/// A point of the sweep's begin or end is exactly where the base then was.
TEST(DeskewCorrection, SweepPoseGoesFromBeginToEnd) {
  RandomNumbers random(6);
  const Pose T_odom_base = random.pose(3.0);
  const SweepPose pose(T_odom_base, jolt());
  const Eigen::Vector3d p = random.inCube(30.0);
  EXPECT_LT((pose.toOdom(p, 0.0) - T_odom_base * p).norm(), 1e-12);
  EXPECT_LT((pose.toOdom(p, 1.0) - T_odom_base * exp(-jolt()) * p).norm(), 1e-12);
}

TEST(RegistrationWithDeskewCorrection, KeepsHalfOfTheErrorThatThePredictionLeaves) {
  const LocalVoxelMap map = mapOfRoom(0.0);
  const WronglyDeskewedScan scan = wronglyDeskewedScan(everyFifth(map.points()), {}, jolt());
  RegistrationConfig with, without;
  with.deskew_damping = with.prediction_weight = without.prediction_weight = 0.0;
  without.deskew_gain = 0.0;
  const RegistrationResult corrected = align(scan, map, with),
                           uncorrected = align(scan, map, without);
  EXPECT_EQ(corrected.outcome, RegistrationOutcome::converged);
  EXPECT_LT(corrected.iterations, 3 * uncorrected.iterations);
  EXPECT_EQ(uncorrected.deskew_correction, Tangent::Zero());
  const Tangent uncorrected_error = log(scan.T_odom_base.inverse() * uncorrected.T_odom_base);
  const Tangent corrected_error = log(scan.T_odom_base.inverse() * corrected.T_odom_base);
  // -fraction (1 - k) / (1 - k fraction) of what was missed, with the mean fraction of a half
  EXPECT_LT((uncorrected_error + 0.5 * jolt()).norm(), 0.15 * jolt().norm());
  EXPECT_LT((corrected_error + 0.25 * jolt()).norm(), 0.15 * jolt().norm());
  const Tangent deviation = log(scan.T_odom_predicted.inverse() * corrected.T_odom_base);
  EXPECT_LT((corrected.deskew_correction - with.deskew_gain * deviation).norm(),
            0.15 * deviation.norm());
}

/// On a plane of which other points are seen nothing tells the way along it.
TEST(RegistrationWithDeskewCorrection, TakesNothingFromDirectionsThatAreNotHeld) {
  RandomNumbers random(9);
  const auto floor = [&](std::size_t count) {
    Points points = random.cloud(count, 15.0);
    for (Eigen::Vector3f& p : points) p.z() = 0.0f;
    return points;
  };
  LocalVoxelMap map({0.5, 20});
  map.insert(floor(60000), {});
  const RegistrationResult result =
      align(wronglyDeskewedScan(floor(3000), {{1, 0, 0, 0}, {0, 0, 0.5}}, jolt()), map, {});
  const Tangent missed = jolt();
  EXPECT_NEAR(result.deskew_correction.z() / missed.z(), 0.5,
              0.1);  // deskew_gain of the 3/4 that came out
  EXPECT_NEAR(result.deskew_correction[4] / missed[4], 0.5, 0.1);
  for (const int along : {0, 1, 5})
    EXPECT_LT(std::abs(result.deskew_correction[along] / missed[along]), 0.02);
}

TEST(RegistrationWithDeskewCorrection, GivesTheSameBitsForAnyNumberOfThreads) {
  const LocalVoxelMap map = mapOfRoom(0.02);
  const WronglyDeskewedScan scan = wronglyDeskewedScan(everyFifth(map.points()), {}, jolt());
  const auto on = [&](int threads) {
    return onThreads(threads, [&] {
      const RegistrationResult result = align(scan, map, {});
      return std::pair(result.T_odom_base.matrix(), result.deskew_correction);
    });
  };
  const auto one = on(1);
  for (const int threads : {2, 4, 3}) EXPECT_EQ(on(threads), one) << threads;
}

TEST(RegistrationWithDeskewCorrection, WithoutCorrespondencesStaysAtThePrediction) {
  const LocalVoxelMap map = mapOfRoom(0.0);
  WronglyDeskewedScan scan = wronglyDeskewedScan(everyFifth(map.points()), {}, jolt());
  scan.T_odom_predicted.translation.x() = 500.0;
  const RegistrationResult result = align(scan, map, {});
  EXPECT_EQ(result.outcome, RegistrationOutcome::too_few_correspondences);
  EXPECT_EQ(result.T_odom_base.matrix(), scan.T_odom_predicted.matrix());
  EXPECT_EQ(result.deskew_correction, Tangent::Zero());
}

}  // namespace
}  // namespace revisit_slam
