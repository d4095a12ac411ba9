// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/simulation/ray_caster.h"
#include "revisit_slam/simulation/route.h"
#include "revisit_slam/simulation/sensor_model.h"
#include "revisit_slam/simulation/world.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam::simulation {

struct ScanConfig {
  std::uint64_t seed = 1;
  /// Standard deviation of the range, metres.
  double noise = 0.02;
  /// Share of measurements that get lost for no reason.
  double random_dropout = 0.005;
  /// The sensor above base_link.
  Pose T_base_sensor{Eigen::Quaterniond::Identity(), {0.0, 0.0, 1.8}};
  /// All rays of a scan from the pose at its end, as if the motion had been taken out.
  bool deskewed = false;
};

struct SimulatedScan {
  /// Points in the sensor's frame; `stamp` is the instant of the last point and `times` count from
  /// it, none positive.
  Scan scan;
  /// The instant of the first firing, which drivers put into the header. For a deskewed scan all
  /// rays fire at its end.
  Stamp first;
  /// For each point: nanoseconds from `first`, ring or line, intensity 0 to 255, and whether it is
  /// of something that moves.
  std::vector<std::uint32_t> nanoseconds;
  std::vector<std::uint16_t> rings;
  std::vector<float> intensities;
  std::vector<bool> moving;
};

/// Measures the world from the route. The same stamp gives the same scan, on any thread.
class ScanSimulator {
 public:
  /// Keeps copies of neither route nor world: both must outlive it.
  ScanSimulator(const World& world, const Route& route, SensorModel sensor, ScanConfig config);

  /// @param start the first firing (of a deskewed scan: one period before the pose).
  SimulatedScan simulate(Stamp start) const;

  const SensorModel& sensor() const { return sensor_; }
  const ScanConfig& config() const { return config_; }

 private:
  struct Ray {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;
    Stamp stamp;
  };

  /// A car or person within range, and a sphere that contains it for the whole scan.
  struct NearMover {
    const Mover* mover;
    Eigen::Vector3d centre;
    double radius;
  };
  struct Hit {
    RayHit hit;
    bool moves;
  };

  std::vector<NearMover> moversAround(Stamp middle) const;
  std::optional<Hit> firstHit(const Ray& ray, const std::vector<NearMover>& movers) const;
  void measure(const Firing& firing, const Ray& ray, std::uint64_t index,
               const std::vector<NearMover>& movers, SimulatedScan& result) const;

  const World& world_;
  const Route& route_;
  SensorModel sensor_;
  ScanConfig config_;
  RayCaster still_;
  std::vector<RayCaster> models_;
  std::vector<Firing> firings_;
};

}  // namespace revisit_slam::simulation
