// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/preprocessing.h"

#include <gtest/gtest.h>

#include "revisit_slam/odometry/odometry.h"
#include "support/random_numbers.h"
#include "support/threads.h"

namespace revisit_slam {
namespace {

OdometryConfig ranges(double nearest, double farthest) {
  OdometryConfig config;
  config.min_range = nearest;
  config.max_range = farthest;
  return config;
}

Tangent driving() {
  Tangent velocity;
  velocity << 15, -1, 0.5, 0.3, -0.2, 1.5;
  return velocity;
}

/// Random world points as a sensor sees them that moves with `velocity` until the scan's stamp.
Scan seenWhileMoving(const Points& points_base, const Tangent& velocity, const Pose& T_base_sensor,
                     RandomNumbers& random) {
  Scan scan{{}, {}, {}, T_base_sensor, {}};
  for (const Eigen::Vector3f& point : points_base) {
    const float time = static_cast<float>(random.uniform(-0.1, 0.0));
    const Pose T_stamp_sensor = exp(time * velocity) * T_base_sensor;
    scan.points.push_back((T_stamp_sensor.inverse() * point.cast<double>()).cast<float>());
    scan.times.push_back(time);
  }
  return scan;
}

TEST(Preprocess, RangeLimitsAreKeptAndAreOfTheSensor) {
  Scan scan;
  scan.T_base_sensor.translation.x() = 100.0;
  for (const float x : {0.99f, 1.0f, 5.0f, -10.0f, 10.01f, 20.0f, 0.1f})
    scan.points.emplace_back(0.0f, x, 0.0f);
  const PreprocessedScan result = preprocess(scan, ConstantMotion(), ranges(1.0, 10.0));
  EXPECT_EQ(result.points_base, (Points{{100, 1, 0}, {100, 5, 0}, {100, -10, 0}}));
  EXPECT_EQ(result.too_near, 2u);
  EXPECT_EQ(result.too_far, 2u);
  EXPECT_FALSE(result.deskewed);
}

TEST(Preprocess, KeepsTheOrderOfLargeScansAndCountsEveryPoint) {
  RandomNumbers random(2);
  for (const std::size_t count : {0u, 1u, 8191u, 8192u, 8193u, 50000u}) {
    Scan scan;
    scan.points = random.cloud(count, 10.0);
    for (std::size_t i = 0; i < count; ++i) scan.intensities.push_back(static_cast<float>(i));
    Points kept;
    std::vector<float> kept_intensities;
    std::size_t too_near = 0;
    for (const auto& point : scan.points) {
      if (point.norm() >= 6.0f && point.norm() <= 9.0f) {
        kept.push_back(point);
        kept_intensities.push_back(static_cast<float>(&point - scan.points.data()));
      }
      too_near += point.norm() < 6.0f;
    }
    const PreprocessedScan result = preprocess(scan, ConstantMotion(), ranges(6.0, 9.0));
    EXPECT_EQ(result.points_base, kept);
    EXPECT_EQ(result.intensities, kept_intensities);
    EXPECT_EQ(result.too_near, too_near);
    EXPECT_EQ(result.too_far, count - too_near - kept.size());
  }
}

TEST(Preprocess, DeskewingUndoesAConstantMotion) {
  RandomNumbers random(3);
  for (const Pose& T_base_sensor : {Pose::identity(), random.pose(2.0)}) {
    const Points truth = random.cloud(1000, 40.0);
    const Scan scan = seenWhileMoving(truth, driving(), T_base_sensor, random);
    const auto result = preprocess(scan, ConstantMotion(driving()), ranges(0.0, 200.0));
    EXPECT_TRUE(result.deskewed);
    ASSERT_EQ(result.points_base.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i)
      EXPECT_LT((result.points_base[i] - truth[i]).norm(), 5e-5f);
  }
}

TEST(Preprocess, SweepFractionsAreThoseOfThePointsThatWereKept) {
  RandomNumbers random(6);
  const Scan scan =
      seenWhileMoving(random.cloud(30000, 60.0), Tangent::Zero(), Pose::identity(), random);
  const auto result = preprocess(scan, ConstantMotion(), ranges(20.0, 60.0), 0.08);
  ASSERT_EQ(result.sweep_fractions.size(), result.points_base.size());
  ASSERT_LT(result.sweep_fractions.size(), scan.points.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < scan.points.size() && kept < result.sweep_fractions.size(); ++i) {
    if (scan.points[i] != result.points_base[kept]) continue;
    EXPECT_FLOAT_EQ(result.sweep_fractions[kept], std::min(1.0f, -scan.times[i] / 0.08f));
    ++kept;
  }
  EXPECT_EQ(kept, result.sweep_fractions.size());
  EXPECT_TRUE(preprocess(scan, ConstantMotion(), ranges(20.0, 60.0)).sweep_fractions.empty());
}

TEST(Preprocess, WithoutTimesOrWhenToldSoPointsAreOnlyMovedToTheBase) {
  RandomNumbers random(4);
  const Pose T_base_sensor = random.pose(2.0);
  Scan with_times = seenWhileMoving(random.cloud(100, 40.0), driving(), T_base_sensor, random);
  Scan without_times = with_times;
  without_times.times.clear();
  OdometryConfig no_deskewing = ranges(0.0, 200.0);
  no_deskewing.deskew = false;
  const ConstantMotion motion(driving());
  for (const auto& result : {preprocess(with_times, motion, no_deskewing),
                             preprocess(without_times, motion, ranges(0.0, 200.0))}) {
    EXPECT_FALSE(result.deskewed);
    ASSERT_EQ(result.points_base.size(), 100u);
    for (std::size_t i = 0; i < 100; ++i) {
      const Eigen::Vector3d expected = T_base_sensor * with_times.points[i].cast<double>();
      EXPECT_LT((result.points_base[i].cast<double>() - expected).norm(), 2e-5);
    }
  }
}

TEST(Preprocess, GivesTheSameBitsForAnyNumberOfThreads) {
  RandomNumbers random(5);
  const Scan scan = seenWhileMoving(random.cloud(60000, 60.0), driving(), random.pose(2.0), random);
  const auto on = [&](int threads) {
    return onThreads(threads, [&] {
      return preprocess(scan, ConstantMotion(driving()), ranges(20.0, 60.0)).points_base;
    });
  };
  const Points one = on(1);
  EXPECT_LT(one.size(), scan.points.size());
  EXPECT_EQ(on(2), one);
  EXPECT_EQ(on(4), one);
}

/// Each point from its own sensor, with its range from there.
TEST(Preprocessing, PointsOfSeveralSensorsAreEachInTheirFrame) {
  Scan scan;
  scan.points = {{2.0f, 0.0f, 0.0f}, {0.1f, 0.0f, 0.0f}, {3.0f, 0.0f, 0.0f}, {4.0f, 0.0f, 0.0f}};
  scan.views = {{{Eigen::Quaterniond::Identity(), {10.0, 0.0, 1.0}}, 2},
                {{expSO3({0.0, 0.0, M_PI}), {-10.0, 0.0, 2.0}}, 4}};
  const PreprocessedScan result = preprocess(scan, ConstantMotion(), ranges(0.5, 20.0));
  ASSERT_EQ(result.points_base.size(), 3u);
  EXPECT_EQ(result.too_near, 1u);
  EXPECT_LT((result.points_base[0] - Eigen::Vector3f(12.0f, 0.0f, 1.0f)).norm(), 1e-5f);
  EXPECT_LT((result.points_base[1] - Eigen::Vector3f(-13.0f, 0.0f, 2.0f)).norm(), 1e-5f);
  ASSERT_EQ(result.views.size(), 2u);
  EXPECT_EQ(result.views[0].end, 1u);
  EXPECT_EQ(result.views[1].end, 3u);
  EXPECT_EQ(result.views[1].sensor_base, Eigen::Vector3d(-10.0, 0.0, 2.0));
}

TEST(Preprocessing, PointsInTheBoxOfTheRobotAreDropped) {
  OdometryConfig config = ranges(0.0, 20.0);
  config.body = "-1 -1 0  1 1 2";
  Scan scan;
  scan.T_base_sensor.translation.z() = 1.8;
  scan.points = {{0.5f, 0.0f, 0.0f}, {0.5f, 0.0f, 0.5f}, {3.0f, 0.0f, 0.0f}};
  const PreprocessedScan result = preprocess(scan, ConstantMotion(), config);
  EXPECT_EQ(result.on_body, 1u);
  EXPECT_EQ(result.points_base.size(), 2u);
  config.body = "1 2 3";
  EXPECT_THROW(Odometry{config}, ParameterError);
}

}  // namespace
}  // namespace revisit_slam
