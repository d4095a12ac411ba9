// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "revisit_slam/input/point_cloud.h"
#include "revisit_slam/input/point_reader.h"
#include "simulation/simulation_fixtures.h"

namespace revisit_slam {

using simulation::SimulatedScan;

/// Three scans of a wall and a floor, 0.1 s after one another.
inline std::vector<SimulatedScan> simulatedScans(const std::string& sensor, int columns) {
  const simulation::Route route = simulation::straightRoute(6.0, 9.0);
  const simulation::World world = simulation::wallAhead();
  const simulation::ScanSimulator simulator(world, route, simulation::makeSensor(sensor, columns),
                                            {});
  std::vector<SimulatedScan> scans;
  for (const double seconds : {0.5, 0.6, 0.7})
    scans.push_back(simulator.simulate(route.start().plusSeconds(seconds)));
  return scans;
}

inline ScanReading readWith(PointReader& reader, const PointCloud& cloud) {
  return reader.read(viewOf(cloud), {cloud.stamp, "header", {}});
}

/// The cloud is read as this scan, each point at its instant to `tick` seconds.
inline void expectDeskewable(const PointCloud& cloud, const SimulatedScan& expected,
                             double tick = 1e-8) {
  PointReader reader({});
  const ScanReading reading = readWith(reader, cloud);
  ASSERT_TRUE(reading.scan) << reading.detail;
  EXPECT_TRUE(reader.deskewing()) << reader.description();
  const Scan &read = *reading.scan, &truth = expected.scan;
  ASSERT_EQ(read.points.size(), truth.points.size());
  EXPECT_EQ(cloud.stamp, expected.first);
  EXPECT_NEAR(secondsBetween(truth.stamp, read.stamp), 0.0, tick);
  for (std::size_t i = 0; i < truth.points.size(); ++i) {
    ASSERT_EQ(read.points[i], truth.points[i]) << i;
    ASSERT_NEAR(read.times[i], truth.times[i], 2 * tick) << i;
  }
}

/// The cloud is read as these points, all of the instant of its stamp.
inline void expectWithoutTimes(const PointCloud& cloud, const Points& points, Stamp stamp,
                               float tolerance = 0.f) {
  PointReader reader({});
  const ScanReading reading = readWith(reader, cloud);
  ASSERT_TRUE(reading.scan) << reading.detail;
  EXPECT_FALSE(reader.deskewing()) << reader.description();
  EXPECT_EQ(reading.scan->stamp, stamp);
  ASSERT_EQ(reading.scan->points.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_LE((reading.scan->points[i] - points[i]).norm(), tolerance) << i;
}

inline void expectPose(const Pose& pose, const Pose& expected, double tolerance = 1e-9) {
  const Pose difference = expected.inverse() * pose;
  EXPECT_NEAR(difference.translation.norm(), 0.0, tolerance);
  EXPECT_NEAR(difference.angle(), 0.0, tolerance);
}

}  // namespace revisit_slam
