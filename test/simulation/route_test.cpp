// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/route.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "revisit_slam/simulation/revisits.h"
#include "revisit_slam/util/parameters.h"
#include "simulation_fixtures.h"

namespace revisit_slam::simulation {
namespace {

double yawOf(const Pose& T) {
  const Eigen::Vector3d forward = T.rotation * Eigen::Vector3d::UnitX();
  return std::atan2(forward.y(), forward.x());
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * 3.141592653589793);
}

bool hasRevisit(const Route& route, RevisitKind kind, double least_seconds) {
  const auto revisits = findRevisits(route);
  return std::any_of(revisits.begin(), revisits.end(), [&](const Revisit& revisit) {
    return revisit.kind == kind &&
           secondsBetween(revisit.later_from, revisit.later_until) >= least_seconds;
  });
}

struct Case {
  WorldKind world;
  const char* route;
  double length;
};

TEST(Route, IsSmooth) {
  for (const Case& c :
       {Case{WorldKind::kTown, "tour", 600}, Case{WorldKind::kTown, "lateral", 600},
        Case{WorldKind::kTown, "out-and-back", 500}, Case{WorldKind::kRamp, "tour", 900},
        Case{WorldKind::kCampus, "figure-eight", 300}, Case{WorldKind::kAisles, "tour", 400},
        Case{WorldKind::kStoreys, "tour", 800}}) {
    RouteConfig config = shortDrive(c.route, c.length);
    config.world = c.world;
    const Route route = makeRoute(config);
    constexpr double kStep = 0.02;
    double previous_rate = 0.0;
    for (double t = 1.0; route.start().plusSeconds(t) < route.end(); t += kStep) {
      const Pose a = route.poseAt(route.start().plusSeconds(t));
      const Pose b = route.poseAt(route.start().plusSeconds(t + kStep));
      const double rate = wrapped(yawOf(b) - yawOf(a)) / kStep;
      ASSERT_LT((b.translation - a.translation).norm(), 10.0 * kStep) << c.route << " at " << t;
      ASSERT_LT(std::abs(rate), 1.6) << c.route << " at " << t;
      ASSERT_LT(std::abs(rate - previous_rate), 0.2) << c.route << " at " << t;
      previous_rate = rate;
    }
    EXPECT_NEAR(route.length(), c.length, 1.0);
  }
}

TEST(Route, HasThePromisedRevisits) {
  for (const WorldKind world : {WorldKind::kTown, WorldKind::kField}) {
    RouteConfig config = shortDrive();
    config.world = world;
    const auto route = [&](const char* name, double length) {
      config.route = name;
      config.length = length;
      return makeRoute(config);
    };
    EXPECT_TRUE(hasRevisit(route("loop", 900), RevisitKind::kSame, 20.0));
    EXPECT_TRUE(hasRevisit(route("opposite", 900), RevisitKind::kOpposite, 5.0));
    EXPECT_TRUE(hasRevisit(route("lateral", 900), RevisitKind::kLateral, 20.0));
    EXPECT_TRUE(hasRevisit(route("crossing", 900), RevisitKind::kCrossing, 0.5));
    EXPECT_TRUE(hasRevisit(route("out-and-back", 900), RevisitKind::kOpposite, 20.0));
    EXPECT_FALSE(findRevisits(route("figure-eight", 900)).empty());
    EXPECT_FALSE(findRevisits(route("tour", 1500)).empty());
  }
}

TEST(Route, LateralLapKeepsItsDistance) {
  RouteConfig config = shortDrive("lateral", 900);
  config.lateral_offset = 4.0;
  const Route route = makeRoute(config);
  std::vector<double> distances;
  for (double arc = route.length() - 100.0; arc < route.length() - 5.0; arc += 5.0) {
    double nearest = 1e9;
    for (double other = 0.0; other < arc - 200.0; other += 0.1) {
      nearest =
          std::min(nearest, (route.positionAt(other) - route.positionAt(arc)).head<2>().norm());
    }
    distances.push_back(nearest);
  }
  std::nth_element(distances.begin(), distances.begin() + 10, distances.end());
  EXPECT_NEAR(distances[10], 4.0, 0.2);
}

TEST(Route, RampLevelsLieAboveEachOther) {
  RouteConfig config = shortDrive("tour", 900);
  config.world = WorldKind::kRamp;
  const Route route = makeRoute(config);
  double largest_gap = 0.0;
  for (std::size_t i = 0; i < route.path().size(); i += 4) {
    for (std::size_t j = i + 50; j < route.path().size(); j += 4) {
      const Eigen::Vector3d apart = route.path()[j] - route.path()[i];
      if (apart.head<2>().norm() < 2.0) largest_gap = std::max(largest_gap, std::abs(apart.z()));
    }
  }
  EXPECT_GT(largest_gap, 3.0);
}

TEST(Route, NamesWhatIsWrong) {
  EXPECT_THROW(makeRoute(shortDrive("loop", 50.0)), ParameterError);
  EXPECT_THROW(makeRoute(shortDrive("no-such-file.txt")), ParameterError);
  RouteConfig config = shortDrive();
  config.speed = -1.0;
  EXPECT_THROW(makeRoute(config), ParameterError);
}

}  // namespace
}  // namespace revisit_slam::simulation
