// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "revisit_slam/simulation/drive.h"
#include "support/brute_force_objective.h"

namespace revisit_slam {
namespace {

class FastOnSimulatedScans : public ::testing::TestWithParam<const char*> {};

TEST_P(FastOnSimulatedScans, EqualsBruteForceToTheLastBit) {
  using namespace simulation;
  RouteConfig config;
  config.route = "tour";
  config.length = 400.0;
  const Route route = makeRoute(config);
  const World world = makeWorld({}, route);
  const ScanSimulator simulator(world, route, makeSensor(GetParam()), {});
  BruteForceComparison comparison(12);
  Odometry odometry{OdometryConfig{}};
  simulateDrive(simulator, route, 15, 2, [&](int, const SimulatedScan& simulated) {
    comparison.registerScan(odometry, simulated.scan);
  });
  EXPECT_EQ(comparison.compared(), 3);
}

INSTANTIATE_TEST_SUITE_P(Sensors, FastOnSimulatedScans,
                         ::testing::Values("spinning-64", "rosette"));

}  // namespace
}  // namespace revisit_slam
