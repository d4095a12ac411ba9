// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "revisit_slam/evaluation/absolute_error.h"
#include "revisit_slam/odometry/odometry.h"
#include "revisit_slam/simulation/drive.h"
#include "revisit_slam/slam/information_stage.h"
#include "revisit_slam/slam/slam.h"

namespace revisit_slam {

/// A simulated drive, registered and informed once, for as many runs of the stages behind as
/// wanted.
struct InformedDrive {
  std::vector<InformedScan> scans;
  std::vector<Pose> truth;  ///< T_world_base at the stamps of the scans
};

inline InformedDrive simulateInformedDrive(const std::string& route_name, double length,
                                           const std::string& sensor, int columns, unsigned seed,
                                           const SlamConfig& config,
                                           const simulation::VisitConfig& visit = {}) {
  using namespace simulation;
  RouteConfig route_config;
  route_config.route = route_name;
  route_config.length = length;
  route_config.seed = seed;
  route_config.visit = visit;
  const Route route = makeRoute(route_config);
  const World world = makeWorld({}, worldRoute(route_config), route);
  const ScanSimulator simulator(world, route, makeSensor(sensor, columns), {});
  OdometryStage odometry(config);
  InformationStage information(config.information);
  InformedDrive drive;
  simulateDrive(simulator, route, scanCount(route), 2, [&](int, const SimulatedScan& simulated) {
    ScanReading reading;
    reading.scan = simulated.scan;
    const OdometryStage::Result result = odometry.process(std::move(reading)).at(0);
    drive.truth.push_back(route.poseAt(result.output.scan->stamp));
    drive.scans.push_back(information.inform(result.output));
  });
  return drive;
}

/// Keeps what a run came up with.
class SlamRecorder : public SlamObserver {
 public:
  void onMaps(const MapUpdate& update) override { maps.push_back(update); }
  void onLoopSearch(const LoopSearchResult& result) override { searches.push_back(result); }
  void onCorrection(const MapCorrectionPtr& correction) override {
    corrections.push_back(correction);
  }

  std::vector<MapUpdate> maps;
  std::vector<LoopSearchResult> searches;
  std::vector<MapCorrectionPtr> corrections;
};

/// RMSE of positions after rigid alignment, m. Of the scans from `first` on: starting from rest the
/// odometry slips, which no loop can mend.
inline double errorOf(const Trajectory& trajectory, const std::vector<Pose>& truth,
                      std::size_t first) {
  TrajectoryMatch match;
  for (std::size_t i = first; i < truth.size(); ++i) {
    match.estimate.push_back(trajectory[i]);
    match.reference.push_back({trajectory[i].stamp, truth[i]});
  }
  return absoluteError(match).rmse;
}

}  // namespace revisit_slam
