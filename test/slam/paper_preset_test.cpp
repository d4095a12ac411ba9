// SPDX-License-Identifier: MIT
// The preset `paper` beside what it is to be: KISS-ICP's odometry and Retro-SLAM, the paper
// authors' own implementation. Their errors stand in paper_reference.json, which
// scripts/paper_reference makes of the PyPI packages on the same simulated drives.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "revisit_slam/evaluation/evaluation.h"
#include "revisit_slam/io/presets.h"
#include "revisit_slam/session/session_graph.h"
#include "revisit_slam/simulation/drive.h"
#include "revisit_slam/slam/slam.h"

namespace revisit_slam {
namespace {

using nlohmann::json;

SlamConfig paperConfig() {
  SlamConfig config;
  const std::vector<Parameter> parameters = parametersOf(config);
  assign(parameters, readPreset("paper"));
  return config;
}

/// What is compared of a drive.
struct DriveResult {
  std::size_t points = 0;
  Trajectory odometry;  ///< of the sensor
  TrajectoryEvaluation odometry_errors, corrected_errors;
};

class OdometryRecorder : public SlamObserver {
 public:
  void onScan(const InformedScan& informed, const StageTimes&) override {
    odometry.push_back({informed.scan->stamp, informed.scan->T_odom_base});
  }
  Trajectory odometry;
};

/// The peers work in the frame of the sensor, and their poses are those of the base.
Trajectory ofBase(Trajectory of_sensor, const Pose& T_base_sensor) {
  for (StampedPose& pose : of_sensor)
    pose.T_world_base = T_base_sensor * pose.T_world_base * T_base_sensor.inverse();
  return of_sensor;
}

/// As the program `simulate` makes it.
DriveResult driveThrough(const json& drive) {
  using namespace simulation;
  RouteConfig route_config;
  route_config.route = drive.at("route").get<std::string>();
  route_config.length = drive.at("length");
  route_config.speed = drive.at("speed");
  route_config.seed = drive.at("seed");
  ScanConfig scan_config;
  scan_config.seed = route_config.seed;
  const Route route = makeRoute(route_config);
  const World world = makeWorld({}, route);
  const SensorModel sensor =
      makeSensor(drive.at("sensor").get<std::string>(), drive.at("columns").get<int>());
  const ScanSimulator simulator(world, route, sensor, scan_config);
  OdometryRecorder recorder;
  InlineExecutor executor;
  Slam slam(paperConfig(), recorder, executor);
  Trajectory truth;
  std::size_t points = 0;
  simulateDrive(simulator, route, scanCount(route), 2, [&](int, const SimulatedScan& simulated) {
    ScanReading reading;
    reading.scan = simulated.scan;
    reading.scan->T_base_sensor = Pose::identity();
    points += reading.scan->points.size();
    truth.push_back({simulated.scan.stamp, route.poseAt(simulated.scan.stamp)});
    slam.insert(std::move(reading));
  });
  slam.finish();
  const PoseInterpolator reference(truth);
  const auto judged = [&](const Trajectory& of_sensor) {
    return evaluateTrajectory(PoseInterpolator(ofBase(of_sensor, scan_config.T_base_sensor)),
                              reference);
  };
  return {points, recorder.odometry, judged(recorder.odometry),
          judged(trajectoryOf(graphOf(slam.session()->graph())))};
}

void expectBetween(double lowest, double highest, double ours, const json& theirs,
                   const std::string& what) {
  EXPECT_GE(ours, lowest * theirs.get<double>()) << what;
  EXPECT_LE(ours, highest * theirs.get<double>()) << what;
}

class PaperPreset : public testing::TestWithParam<int> {};

/// Where KISS-ICP goes, until differences in the last digits have grown: a micrometre of noise on
/// the points changes its own ATE of these drives by up to 2 %. Another Embree than the one that
/// made the drives of paper_reference.json makes other points, of which the ATE of KISS-ICP is not
/// known.
TEST_P(PaperPreset, HasTheErrorsOfKissIcpAndOfRetroSlam) {
  std::ifstream file("test/slam/paper_reference.json");
  const json drive = json::parse(file).at("drives").at(static_cast<std::size_t>(GetParam()));
  const json& theirs = drive.at("errors");
  const DriveResult ours = driveThrough(drive);
  std::size_t scan = 0;
  for (const json& position : drive.at("first_positions_of_kiss_icp")) {
    const Eigen::Vector3d expected(position[0].get<double>(), position[1].get<double>(),
                                   position[2].get<double>());
    EXPECT_LT((ours.odometry[scan++].T_world_base.translation - expected).norm(), 1e-3) << scan;
  }
  const json &kiss = theirs.at("kiss-icp"), &retro = theirs.at("retro-slam");
  expectBetween(0.98, 1.02, ours.odometry_errors.relative.translation_percent, kiss["rpe_percent"],
                "odometry, RPE");
  // The registration of submaps, which the paper leaves open, is ours.
  expectBetween(0.80, 1.15, ours.corrected_errors.absolute.rmse, retro["ate_m"], "corrected, ATE");
  expectBetween(0.80, 1.15, ours.corrected_errors.relative.translation_percent,
                retro["rpe_percent"], "corrected, RPE");
  if (ours.points != drive.at("points").get<std::size_t>())
    GTEST_SKIP() << "all but the ATE of the odometry is compared: another Embree made "
                 << ours.points << " points here";
  expectBetween(0.95, 1.05, ours.odometry_errors.absolute.rmse, kiss["ate_m"], "odometry, ATE");
}

INSTANTIATE_TEST_SUITE_P(ThreeDrives, PaperPreset, testing::Values(0, 1, 2));

}  // namespace
}  // namespace revisit_slam
