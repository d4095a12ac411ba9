// SPDX-License-Identifier: MIT
// The robot is carried to another place within the time of a scan, and later comes by where it was
// before.
#include <gtest/gtest.h>

#include <algorithm>

#include "revisit_slam/session/session_graph.h"
#include "support/simulated_slam.h"

namespace revisit_slam {
namespace {

constexpr double kCarriedFrom = 330.0, kCarriedTo = 480.0;  // m, along the route

struct CarriedDrive {
  InformedDrive drive;
  std::size_t carried = 0;  // the first scan after it
};

/// Without what the sensor would have seen on the way, and with stamps that go on.
CarriedDrive carriedDrive(const SlamConfig& config) {
  using namespace simulation;
  RouteConfig route_config;
  route_config.route = "opposite";
  route_config.length = 1000.0;
  route_config.seed = 5;
  const Route route = makeRoute(route_config);
  const World world = makeWorld({}, worldRoute(route_config), route);
  const ScanSimulator simulator(world, route, makeSensor("spinning-64", 256), {});
  OdometryStage odometry(config);
  InformationStage information(config.information);
  CarriedDrive all;
  double travelled = 0.0, skipped = 0.0;
  std::optional<Pose> before;
  std::optional<Stamp> last;
  simulateDrive(simulator, route, scanCount(route), 2, [&](int, const SimulatedScan& simulated) {
    const Pose T_world_base = route.poseAt(simulated.scan.stamp);
    if (before) travelled += (T_world_base.translation - before->translation).norm();
    before = T_world_base;
    const bool is_carried = kCarriedFrom < travelled && travelled < kCarriedTo;
    if (is_carried && last) skipped += secondsBetween(*last, simulated.scan.stamp);
    last = simulated.scan.stamp;
    if (is_carried) return;
    if (skipped > 0.0 && all.carried == 0) all.carried = all.drive.scans.size();
    ScanReading reading;
    reading.scan = simulated.scan;
    reading.scan->stamp = simulated.scan.stamp.plusSeconds(-skipped);
    const OdometryStage::Result result = odometry.process(std::move(reading)).at(0);
    all.drive.truth.push_back(T_world_base);
    all.drive.scans.push_back(information.inform(result.output));
  });
  return all;
}

TEST(Kidnapping, IsToldAndALoopBringsThePiecesTogether) {
  const CarriedDrive carried = carriedDrive({});
  const InformedDrive& drive = carried.drive;
  ASSERT_GT(carried.carried, 200u);
  const auto after = drive.scans.begin() + static_cast<std::ptrdiff_t>(carried.carried);
  EXPECT_TRUE(std::any_of(after, after + 3, [](const InformedScan& scan) {
    return scan.verdict == PoseVerdict::lost;
  }));
  // The edge across has a sigma of the size of the error.
  double variance = 0.0;
  for (auto scan = after; scan != after + 5; ++scan)
    variance += scan->covariance_motion.topLeftCorner<2, 2>().trace();
  EXPECT_GT(3.0 * std::sqrt(variance), kCarriedTo - kCarriedFrom);

  SlamConfig config;
  SlamRecorder recorder;
  StagedExecutor executor(config.background);
  Slam slam(config, recorder, executor);
  for (const InformedScan& scan : drive.scans) slam.insert(scan);
  slam.finish();
  const bool ties_pieces =
      std::any_of(slam.session()->graph().loops().begin(), slam.session()->graph().loops().end(),
                  [&](const LoopEdge& edge) {
                    return edge.state == LoopState::active &&
                           edge.loop.constraint.from.value < carried.carried &&
                           edge.loop.constraint.to.value >= carried.carried;
                  });
  EXPECT_TRUE(ties_pieces);
  const Trajectory trajectory = trajectoryOf(graphOf(slam.session()->graph()));
  ASSERT_EQ(trajectory.size(), drive.scans.size());
  const double error = errorOf(trajectory, drive.truth, 150);
  EXPECT_LT(error, 1.0);
  RecordProperty("error_m", std::to_string(error));
}

}  // namespace
}  // namespace revisit_slam
