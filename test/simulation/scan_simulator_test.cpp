// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/scan_simulator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation_fixtures.h"

namespace revisit_slam::simulation {
namespace {

/// Points in the map frame, each by the true pose at its own instant.
std::vector<Eigen::Vector3d> placed(const SimulatedScan& scan, const Route& route) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < scan.scan.points.size(); ++i) {
    const Stamp stamp{scan.first.nanoseconds + scan.nanoseconds[i]};
    points.push_back(route.poseAt(stamp) *
                     (scan.scan.T_base_sensor * scan.scan.points[i].cast<double>().eval()));
  }
  return points;
}

/// Root mean square distance from the wall of the points on it.
double distanceFromWall(const std::vector<Eigen::Vector3d>& points) {
  double sum = 0.0;
  int count = 0;
  for (const auto& p : points) {
    if (p.z() < 0.5 || std::abs(p.y()) > 4.0) continue;
    sum += std::pow(p.x() - 10.0, 2);
    ++count;
  }
  EXPECT_GT(count, 100);
  return std::sqrt(sum / std::max(count, 1));
}

TEST(ScanSimulator, MeasuresTheWallFromWhereEachRayStarts) {
  for (const MotionKind motion : {MotionKind::kVehicle, MotionKind::kHandheld}) {
    const Route route = straightRoute(6.0, 9.0, motion);
    const World world = wallAhead();
    const ScanSimulator simulator(world, route, makeSensor("spinning-64"), {});
    const SimulatedScan scan = simulator.simulate(route.start().plusSeconds(0.7));
    EXPECT_NEAR(distanceFromWall(placed(scan, route)), 0.02, 0.003);
  }
}

TEST(ScanSimulator, IsExactWithoutNoise) {
  const Route route = straightRoute(6.0, 9.0);
  const World world = wallAhead();
  ScanConfig config;
  config.noise = 0.0;
  const ScanSimulator simulator(world, route, makeSensor("narrow"), config);
  EXPECT_LT(distanceFromWall(placed(simulator.simulate(route.start().plusSeconds(0.5)), route)),
            1e-4);
}

TEST(ScanSimulator, CastsDeskewedScansFromTheEnd) {
  const Route route = straightRoute(6.0, 9.0);
  const World world = wallAhead();
  ScanConfig config;
  config.noise = 0.0;
  config.deskewed = true;
  const ScanSimulator simulator(world, route, makeSensor("spinning-64"), config);
  const Stamp start = route.start().plusSeconds(0.7);
  const SimulatedScan scan = simulator.simulate(start);
  EXPECT_EQ(scan.scan.stamp, start.plusSeconds(0.1));
  EXPECT_EQ(scan.scan.times.front(), 0.0F);
  EXPECT_LT(distanceFromWall(placed(scan, route)), 1e-4);
}

TEST(ScanSimulator, StampsTheLastPoint) {
  const Route route = straightRoute(6.0, 9.0);
  const World world = wallAhead();
  const ScanSimulator simulator(world, route, makeSensor("spinning-16"), {});
  const SimulatedScan scan = simulator.simulate(route.start());
  ASSERT_EQ(scan.scan.times.size(), scan.scan.points.size());
  EXPECT_EQ(scan.first, route.start());
  EXPECT_EQ(scan.scan.times.back(), 0.0F);
  EXPECT_EQ(scan.scan.stamp.nanoseconds, scan.first.nanoseconds + scan.nanoseconds.back());
  EXPECT_TRUE(std::is_sorted(scan.scan.times.begin(), scan.scan.times.end()));
  for (const auto& p : scan.scan.points) ASSERT_GE(p.norm(), 0.5F);
}

TEST(ScanSimulator, TwoScansOfAStaticTownCoincideAtTheTruth) {
  const Route route = makeRoute(shortDrive());
  const World world = makeWorld({0}, route);
  const ScanSimulator simulator(world, route, makeSensor("spinning-64"), {});
  const auto first = placed(simulator.simulate(route.start().plusSeconds(20.0)), route);
  const auto second = placed(simulator.simulate(route.start().plusSeconds(20.4)), route);
  int near = 0, tried = 0;
  for (std::size_t i = 0; i < second.size(); i += 97) {
    double nearest = 1e9;
    for (const auto& p : first) nearest = std::min(nearest, (p - second[i]).squaredNorm());
    ++tried;
    if (nearest < 0.3 * 0.3) ++near;
  }
  EXPECT_GT(near, 0.85 * tried);
}

TEST(ScanSimulator, PointsOfWhatMovesAreMarked) {
  World world = wallAhead();
  TriangleMesh panel;  // across the view, 1 m wide and high
  panel.vertices = {{0, -0.5, 0.5}, {0, 0.5, 0.5}, {0, 0.5, 1.5}, {0, -0.5, 1.5}};
  panel.triangles = {{0, 1, 2}, {0, 2, 3}};
  panel.materials = {Material::kCloth, Material::kCloth};
  world.models = {panel};
  const Route route = straightRoute(1.0, 3.0);
  UniformSpline<6>::Value here;
  here << 6.0, 0.0, 0.0, 1.0, 0.0, 0.0;
  world.people = {{0, route.start(), route.end(), UniformSpline<6>({here, here}, 10.0)}};
  const ScanSimulator simulator(world, route, makeSensor("spinning-64"), {});
  const SimulatedScan scan = simulator.simulate(route.start());
  ASSERT_EQ(scan.moving.size(), scan.scan.points.size());
  int marked = 0;
  for (std::size_t i = 0; i < scan.moving.size(); ++i) {
    const Eigen::Vector3f& p = scan.scan.points[i];
    const bool on_panel = std::abs(p.x() - 6.0f) < 0.3f && std::abs(p.y()) < 0.6f && p.z() > -1.5f;
    EXPECT_EQ(scan.moving[i], on_panel) << p.transpose();
    marked += scan.moving[i];
  }
  EXPECT_GT(marked, 50);
}

TEST(Drive, DoesNotDependOnTheNumberOfThreads) {
  RouteConfig config = shortDrive("loop");
  const Route route = makeRoute(config);
  const World world = makeWorld({}, route);
  const World again = makeWorld({}, makeRoute(config));
  EXPECT_FALSE(world.cars.empty());
  const auto runWith = [&](const World& in, int threads) {
    const ScanSimulator simulator(in, route, makeSensor("rosette", 500), {});
    std::vector<SimulatedScan> scans;
    simulateDrive(simulator, route, 12, threads, [&](int index, const SimulatedScan& scan) {
      EXPECT_EQ(index, static_cast<int>(scans.size()));
      scans.push_back(scan);
    });
    return scans;
  };
  const auto one = runWith(world, 1), many = runWith(again, 4);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].scan.points, many[i].scan.points);
    EXPECT_EQ(one[i].intensities, many[i].intensities);
    EXPECT_EQ(one[i].nanoseconds, many[i].nanoseconds);
  }
}

}  // namespace
}  // namespace revisit_slam::simulation
