// SPDX-License-Identifier: MIT
// What the information costs beside the odometry, and beside a brute-force evaluation, in one run.
#include <sensor_msgs/PointCloud2.h>
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "revisit_slam/information/information_estimator.h"
#include "revisit_slam/odometry/odometry.h"
#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/ros/input/scan_reader.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/util/process_usage.h"

namespace revisit_slam {
namespace {

/// Evaluates the objective at every sample by a search of the map for every point.
double bruteForce(const Points& points, const LocalVoxelMap& map, const Pose& T_odom_base,
                  double tau, const InformationConfig& config) {
  double sum = 0.0;
  for (const PerturbationDesign& design : makeDesigns(config))
    for (const Tangent& sample : design.samples()) {
      const Pose T = boxplus(T_odom_base, sample);
      const Eigen::Matrix3d R = T.rotationMatrix();
      for (const Eigen::Vector3f& point : points) {
        Neighbour neighbour;
        const Eigen::Vector3d p = R * point.cast<double>() + T.translation;
        const bool found = map.nearest(p, tau, neighbour);
        sum += found ? neighbour.distance * neighbour.distance : tau * tau;
      }
    }
  return sum;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// CPU milliseconds since the last call.
class CpuClock {
 public:
  double lap() {
    const double now = processCpuSeconds();
    return 1e3 * (now - std::exchange(last_, now));
  }

 private:
  double last_ = processCpuSeconds();
};

void run(const std::string& path, const std::string& topic, const SlamConfig& config,
         std::size_t max_scans) {
  const InformationEstimator estimator(config.information);
  InformationConfig all_points_config = config.information;
  all_points_config.max_points = 1000000;
  const InformationEstimator all_points(all_points_config);
  std::vector<double> odometry_ms, fast_ms, all_points_ms, brute_ms;
  double checksum = 0.0;

  const auto measure = [&](const RegisteredScan& scan, const LocalVoxelMap& map) {
    CpuClock clock;
    const double tau = Registration::maxCorrespondenceDistance(scan.sigma);
    const RegistrationProblem problem =
        estimator.gather(scan.source_base, map, scan.T_odom_base, tau);
    checksum += estimator.estimate(problem).mean_squared_residual;
    fast_ms.push_back(clock.lap());
    if (scan.id.value % 10 == 0) {
      all_points.estimate(all_points.gather(scan.source_base, map, scan.T_odom_base, tau));
      all_points_ms.push_back(clock.lap());
      checksum +=
          bruteForce(scan.source_base, map, scan.T_odom_base, problem.tau, config.information);
      brute_ms.push_back(clock.lap());
    }
  };

  BagScans bag({path}, topic);
  ScanReader reader(config.input);
  Odometry odometry(config.odometry);
  tbb::task_arena arena(config.odometry.threads);
  for (const rosbag::MessageInstance& instance : bag.messages()) {
    if (odometry_ms.size() == max_scans) break;
    const RawMessage message = rawMessageOf(instance);
    CpuClock clock;
    const ScanReading reading = reader.read(message);
    if (!reading.scan) continue;
    arena.execute([&] {
      const OdometryResult result = odometry.align(*reading.scan);
      if (!result.scan) return;
      double own_ms = clock.lap();
      if (!odometry.map().empty()) measure(*result.scan, odometry.map());
      clock.lap();
      odometry.commit();
      odometry_ms.push_back(own_ms + clock.lap());
    });
  }
  const double own = median(odometry_ms);
  const auto line = [&](const char* name, double ms) {
    std::printf("| %s | %.2f ms | %.0f %% |\n", name, ms, 100.0 * ms / own);
  };
  std::printf("| CPU time of a scan, median of %zu | | of the odometry |\n|---|---|---|\n",
              odometry_ms.size());
  line("odometry", own);
  line("information", median(fast_ms));
  line("information from all points", median(all_points_ms));
  line("brute force from all points", median(brute_ms));
  std::printf("\n(sum of what was computed, so that it is: %g)\n", checksum);
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  CLI::App app{"CPU time of the information estimate beside that of the odometry"};
  std::string bag, topic;
  std::size_t max_scans = 300;
  revisit_slam::SlamConfig config;
  app.add_option("--bag", bag, "bag file")->required();
  app.add_option("--points,--topic", topic,
                 "topic of the scans; may be left out when there is one");
  app.add_option("--max-scans", max_scans, "stop after so many scans");
  app.add_option("--threads", config.odometry.threads, "threads of the odometry");
  CLI11_PARSE(app, argc, argv);
  try {
    revisit_slam::run(bag, topic, config, max_scans);
  } catch (const std::exception& error) {
    std::cerr << "benchmark_information: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
