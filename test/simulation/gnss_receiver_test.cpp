// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/gnss_receiver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "revisit_slam/geometry/local_enu.h"

namespace revisit_slam::simulation {
namespace {

Route townRoute() {
  RouteConfig config;
  config.route = "loop";
  config.length = 1500.0;
  config.seed = 3;
  return makeRoute(config);
}

/// m, of what was measured, from where the antenna was.
std::vector<Eigen::Vector3d> errorsOf(const Route& route, const GnssReceiverConfig& config,
                                      std::size_t* without = nullptr) {
  const LocalEnu enu(config.datum);
  std::vector<Eigen::Vector3d> errors;
  for (const GnssSample& sample : simulateGnss(route, route.end(), config)) {
    if (!sample.has_position && without != nullptr) ++*without;
    if (sample.has_position)
      errors.push_back(enu.toEnu(sample.position) -
                       route.poseAt(sample.stamp) * config.p_base_antenna);
  }
  return errors;
}

TEST(GnssReceiver, NoiseIsWhatWasAskedFor) {
  GnssReceiverConfig config;
  config.p_base_antenna = {1.0, 0.0, 2.0};
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  const auto errors = errorsOf(townRoute(), config);
  ASSERT_GT(errors.size(), 200u);
  for (const Eigen::Vector3d& error : errors) squares += error.cwiseAbs2();
  const Eigen::Vector3d deviation = (squares / static_cast<double>(errors.size())).cwiseSqrt();
  EXPECT_NEAR(deviation.x(), 1.5, 0.25);
  EXPECT_NEAR(deviation.y(), 1.5, 0.25);
  EXPECT_NEAR(deviation.z(), 3.0, 0.5);
}

TEST(GnssReceiver, OutagesAndJumpsAreAsManyAsWereAskedFor) {
  GnssReceiverConfig config;
  config.noise = 0.01;
  config.outages = 0.2;
  config.jumps = 3;
  std::size_t without = 0, jumped = 0, begun = 0;
  bool before = false;
  const auto errors = errorsOf(townRoute(), config, &without);
  for (const Eigen::Vector3d& error : errors) {
    const bool jumps = std::abs(error.head<2>().norm() - 30.0) < 0.1;
    EXPECT_TRUE(jumps || error.norm() < 0.1);
    jumped += jumps;
    begun += jumps && !before;
    before = jumps;
  }
  EXPECT_NEAR(static_cast<double>(without) / static_cast<double>(without + errors.size()), 0.2,
              0.05);
  EXPECT_LE(jumped, 30u);
  EXPECT_GE(begun, 2u);
}

}  // namespace
}  // namespace revisit_slam::simulation
