// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/sensor_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kDegrees = 180.0 / 3.141592653589793;

double elevation(const Firing& firing) {
  return kDegrees * std::asin(firing.direction.z());
}
double azimuth(const Firing& firing) {
  return kDegrees * std::atan2(firing.direction.y(), firing.direction.x());
}

void expectOrderedUnitRays(const std::vector<Firing>& firings) {
  for (std::size_t i = 0; i < firings.size(); ++i) {
    ASSERT_NEAR(firings[i].direction.norm(), 1.0, 1e-6);
    ASSERT_GE(firings[i].nanoseconds, i == 0 ? 0 : firings[i - 1].nanoseconds);
    ASSERT_LT(firings[i].nanoseconds, SensorModel::kPeriodNanoseconds);
  }
}

TEST(SensorModel, SpinningSensorsLookAllAround) {
  const struct {
    const char* name;
    std::size_t rings;
    double low, high;
  } cases[] = {{"spinning-16", 16, -15.0, 15.0},
               {"spinning-64", 64, -24.8, 2.0},
               {"spinning-128", 128, -22.5, 22.5}};
  for (const auto& sensor : cases) {
    const auto firings = firingsOf(makeSensor(sensor.name), 3);
    expectOrderedUnitRays(firings);
    ASSERT_EQ(firings.size(), sensor.rings * 1024);
    EXPECT_NEAR(elevation(firings.front()), sensor.low, 1e-4);
    EXPECT_NEAR(elevation(firings.back()), sensor.high, 1e-4);
    EXPECT_EQ(firings.back().ring, sensor.rings - 1);
    EXPECT_NEAR(std::abs(azimuth(firings[0])), 180.0, 1e-3);
    EXPECT_NEAR(azimuth(firings[512 * sensor.rings]), 0.0, 1e-3);
  }
}

TEST(SensorModel, RosetteFillsACircleThatChangesFromScanToScan) {
  const SensorModel sensor = makeSensor("rosette");
  const auto first = firingsOf(sensor, 10), second = firingsOf(sensor, 11);
  expectOrderedUnitRays(first);
  ASSERT_EQ(first.size(), 24000U);
  double widest = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    widest = std::max(widest, kDegrees * std::acos(std::min(1.0F, first[i].direction.x())));
    difference += (first[i].direction - second[i].direction).norm() / 24000.0;
  }
  EXPECT_NEAR(widest, 35.0, 0.6);
  EXPECT_GT(difference, 0.1);
}

TEST(SensorModel, NarrowSensorCoversItsRectangle) {
  const auto firings = firingsOf(makeSensor("narrow"), 0);
  expectOrderedUnitRays(firings);
  ASSERT_EQ(firings.size(), 48000U);
  double left = 0.0, right = 0.0, low = 0.0, high = 0.0;
  for (const Firing& firing : firings) {
    left = std::max(left, azimuth(firing));
    right = std::min(right, azimuth(firing));
    low = std::min(low, elevation(firing));
    high = std::max(high, elevation(firing));
  }
  EXPECT_NEAR(left, 60.0, 1e-3);
  EXPECT_NEAR(right, -60.0, 1e-3);
  EXPECT_NEAR(low, -10.0, 1e-3);
  EXPECT_NEAR(high, 10.0, 1e-3);
}

TEST(SensorModel, RefusesUnknownNames) {
  try {
    makeSensor("sonar");
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("sensor = 'sonar'"), std::string::npos);
  }
}

}  // namespace
}  // namespace revisit_slam::simulation
