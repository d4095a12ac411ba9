// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "revisit_slam/simulation/ray_caster.h"
#include "simulation_fixtures.h"

namespace revisit_slam::simulation {
namespace {

TEST(World, NothingStandsWhereThePlatformDrives) {
  for (const auto& [world_kind, length] : {std::pair{WorldKind::kTown, 500.0},
                                           {WorldKind::kCampus, 300.0},
                                           {WorldKind::kBridge, 600.0},
                                           {WorldKind::kRamp, 900.0},
                                           {WorldKind::kMotorway, 500.0},
                                           {WorldKind::kBays, 900.0},
                                           {WorldKind::kTerraces, 900.0},
                                           {WorldKind::kAisles, 400.0},
                                           {WorldKind::kPortals, 900.0},
                                           {WorldKind::kStoreys, 900.0}}) {
    RouteConfig config = shortDrive("tour", length);
    config.world = world_kind;
    const Route route = makeRoute(config);
    const World world = makeWorld({0}, route);
    const RayCaster caster(world.still);
    for (double arc = 1.0; arc + 2.0 < route.length(); arc += 1.0) {
      const Eigen::Vector3d forward = route.directionAt(arc);
      for (const double height : {0.5, 1.0, 1.8}) {
        const Eigen::Vector3d from = route.positionAt(arc) + Eigen::Vector3d(0.0, 0.0, height);
        ASSERT_FALSE(caster.cast(from, forward, 1.0))
            << nameOf(world_kind) << " at " << arc << " m";
      }
      const auto road = caster.cast(route.positionAt(arc) + Eigen::Vector3d(0.0, 0.0, 1.0),
                                    -Eigen::Vector3d::UnitZ(), 3.0);
      ASSERT_TRUE(road) << nameOf(world_kind) << " at " << arc << " m";
      EXPECT_NEAR(road->range, 1.0, 0.12) << nameOf(world_kind) << " at " << arc << " m";
    }
  }
}

TEST(World, MovingCarsKeepAwayFromThePlatform) {
  RouteConfig config = shortDrive("opposite", 1200.0);
  config.stop_and_go = true;
  const Route route = makeRoute(config);
  const World world = makeWorld({}, route);
  ASSERT_GT(world.cars.size(), 5U);
  for (const Mover& car : world.cars) {
    for (Stamp t = car.from; t <= car.until; t = t.plusSeconds(0.05)) {
      const Eigen::Vector3d apart = route.poseAt(t).inverse() * car.poseAt(t).translation;
      const bool beside = std::abs(apart.y()) > 1.9;
      const bool before_or_behind = std::abs(apart.x()) > 4.0;
      ASSERT_TRUE(beside || before_or_behind) << apart.transpose();
    }
  }
}

TEST(World, OnAMotorwayCarsKeepUpWithThePlatformAndOthersComeTowardsIt) {
  RouteConfig config = shortDrive("tour", 1500.0);
  config.world = WorldKind::kMotorway;
  const Route route = makeRoute(config);
  const World world = makeWorld({}, route);
  const Stamp t = route.start().plusSeconds(40.0);
  ASSERT_GT(route.speedAt(t), 15.0);
  int along = 0, oncoming = 0;
  for (const Mover& car : world.cars) {
    if (!car.isPresent(t) || !car.isPresent(t.plusSeconds(0.1))) continue;
    const auto place = [&](Stamp at) -> Eigen::Vector3d {
      return route.poseAt(at).inverse() * car.poseAt(at).translation;
    };
    const double relative_speed = 10.0 * (place(t.plusSeconds(0.1)) - place(t)).norm();
    along += relative_speed < 4.0;
    oncoming += relative_speed > 30.0;
  }
  EXPECT_GE(along, 4);
  EXPECT_GE(oncoming, 1);
}

TEST(World, PeopleWalkOnTheGroundAndKeepAwayFromThePlatformAndFromWalls) {
  RouteConfig config = shortDrive("tour", 200.0);
  config.world = WorldKind::kCampus;
  const Route route = makeRoute(config);
  const World world = makeWorld({0, 30}, route);
  ASSERT_GT(world.people.size(), 10U);
  EXPECT_LE(world.people.size(), 30U);
  const RayCaster caster(world.still);
  for (const Mover& person : world.people) {
    for (Stamp t = person.from; t <= person.until; t = t.plusSeconds(0.5)) {
      const Pose T_map_person = person.poseAt(t);
      const Eigen::Vector3d apart = route.poseAt(t).inverse() * T_map_person.translation;
      ASSERT_GT(apart.head<2>().norm(), 1.0);
      const Eigen::Vector3d head = T_map_person * Eigen::Vector3d(0.0, 0.0, 1.0);
      const auto below = caster.cast(head, -Eigen::Vector3d::UnitZ(), 3.0);
      ASSERT_TRUE(below);
      EXPECT_NEAR(below->range, 1.0, 0.15);
      const Stamp later = t.plusSeconds(0.5);
      if (later > person.until) continue;
      const Eigen::Vector3d step = T_map_person.inverse() * person.poseAt(later).translation;
      EXPECT_GT(step.x(), 0.1);  // forwards
      EXPECT_LT(step.norm(), 1.3);
      EXPECT_FALSE(caster.cast(head, T_map_person.rotation * step.normalized(), step.norm()));
    }
  }
  EXPECT_TRUE(makeWorld({0}, route).people.empty());
}

TEST(World, IsBoundedAndRepeatable) {
  const Route route = makeRoute(shortDrive());
  const World a = makeWorld({3}, route), b = makeWorld({3}, route);
  EXPECT_LE(a.cars.size(), 3U);
  EXPECT_EQ(a.still.vertices, b.still.vertices);
  EXPECT_EQ(a.still.triangles, b.still.triangles);
  EXPECT_EQ(a.still.triangles.size(), a.still.materials.size());
}

/// Triangles of all that is no car, by material.
std::map<Material, int> standing(const World& world) {
  std::map<Material, int> counts;
  for (const Material material : world.still.materials) ++counts[material];
  for (const Material material : world.models.front().materials) counts.erase(material);
  return counts;
}

TEST(World, AVisitFindsOtherCarsInTheSameWorld) {
  RouteConfig config = shortDrive("loop", 500.0);
  const Route first = makeRoute(config);
  const World world = makeWorld({}, first);
  for (const VisitConfig& visit : {VisitConfig{1, false, 1.5}, VisitConfig{2, true, 0.0}}) {
    config.visit = visit;
    const Route route = makeRoute(config);
    const World visited = makeWorld({}, worldRoute(config), route);
    EXPECT_EQ(standing(visited), standing(world));
    EXPECT_NE(visited.still.triangles.size(), world.still.triangles.size());
    const RayCaster caster(visited.still);
    for (double arc = 1.0; arc + 2.0 < route.length(); arc += 1.0) {
      const Eigen::Vector3d from = route.positionAt(arc) + Eigen::Vector3d(0.0, 0.0, 0.8);
      ASSERT_FALSE(caster.cast(from, route.directionAt(arc), 1.0)) << visit.number << " " << arc;
    }
  }
  EXPECT_EQ(makeRoute(shortDrive("loop", 500.0)).path(), worldRoute(config).path());
}

TEST(World, SeedsDiffer) {
  RouteConfig config = shortDrive();
  const Route first = makeRoute(config);
  config.seed = 2;
  const Route second = makeRoute(config);
  EXPECT_NE(makeWorld({0}, first).still.triangles.size(),
            makeWorld({0}, second).still.triangles.size());
}

}  // namespace
}  // namespace revisit_slam::simulation
