// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/scan_simulator.h"

#include <cmath>

#include "echo.h"
#include "revisit_slam/simulation/random.h"

namespace revisit_slam::simulation {
namespace {

/// A sphere of this radius about the middle contains it for the whole scan.
constexpr double kCarRadius = 5.0, kPersonRadius = 2.5;

bool passes(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
            const Eigen::Vector3d& centre, double radius) {
  const Eigen::Vector3d to_centre = centre - origin;
  const double along = to_centre.dot(direction);
  return along > -radius && to_centre.squaredNorm() - along * along < radius * radius;
}

}  // namespace

ScanSimulator::ScanSimulator(const World& world, const Route& route, SensorModel sensor,
                             ScanConfig config)
    : world_(world),
      route_(route),
      sensor_(std::move(sensor)),
      config_(config),
      still_(world.still) {
  for (const TriangleMesh& mesh : world.models) models_.emplace_back(mesh);
  if (sensor_.kind != SensorKind::kRosette) firings_ = firingsOf(sensor_, 0);
}

std::vector<ScanSimulator::NearMover> ScanSimulator::moversAround(Stamp middle) const {
  const Eigen::Vector3d here = route_.poseAt(middle).translation;
  std::vector<NearMover> around;
  const auto take = [&](const std::vector<Mover>& movers, double radius) {
    for (const Mover& mover : movers) {
      if (!mover.isPresent(middle)) continue;
      const Eigen::Vector3d centre = mover.poseAt(middle).translation;
      if ((centre - here).norm() < sensor_.max_range + 2.0 * radius)
        around.push_back({&mover, centre, radius});
    }
  };
  take(world_.cars, kCarRadius);
  take(world_.people, kPersonRadius);
  return around;
}

std::optional<ScanSimulator::Hit> ScanSimulator::firstHit(
    const Ray& ray, const std::vector<NearMover>& movers) const {
  std::optional<Hit> nearest;
  if (const auto hit = still_.cast(ray.origin, ray.direction, sensor_.max_range))
    nearest = Hit{*hit, false};
  for (const NearMover& near : movers) {
    if (!passes(ray.origin, ray.direction, near.centre, near.radius)) continue;
    const Pose T_mover_map = near.mover->poseAt(ray.stamp).inverse();
    const double reach = nearest ? nearest->hit.range : sensor_.max_range;
    const auto hit = models_[static_cast<std::size_t>(near.mover->model)].cast(
        T_mover_map * ray.origin, T_mover_map.rotation * ray.direction, reach);
    if (hit && hit->range < reach) nearest = Hit{*hit, true};
  }
  return nearest;
}

void ScanSimulator::measure(const Firing& firing, const Ray& ray, std::uint64_t index,
                            const std::vector<NearMover>& movers, SimulatedScan& result) const {
  const std::optional<Hit> first = firstHit(ray, movers);
  if (!first) return;
  const RayHit& hit = first->hit;
  const auto key = static_cast<std::uint64_t>(result.first.nanoseconds);
  if (isLost(hit, config_.random_dropout, hashOf(config_.seed, key, index, 1))) return;
  const double noise = config_.noise * gaussianFrom(hashOf(config_.seed, key, index, 2));
  const double range = hit.range + noise;
  if (range < sensor_.min_range || range > sensor_.max_range) return;
  result.scan.points.push_back(static_cast<float>(range) * firing.direction);
  result.nanoseconds.push_back(config_.deskewed ? 0U
                                                : static_cast<std::uint32_t>(firing.nanoseconds));
  result.rings.push_back(firing.ring);
  result.intensities.push_back(intensityOf(hit, hashOf(config_.seed, key, index, 3)));
  result.moving.push_back(first->moves);
}

SimulatedScan ScanSimulator::simulate(Stamp start) const {
  SimulatedScan result;
  result.first =
      config_.deskewed ? Stamp{start.nanoseconds + SensorModel::kPeriodNanoseconds} : start;
  const std::int64_t since = start.nanoseconds - route_.start().nanoseconds;
  const auto scan_index = static_cast<std::uint64_t>(since / SensorModel::kPeriodNanoseconds);
  const std::vector<Firing> own =
      firings_.empty() ? firingsOf(sensor_, scan_index) : std::vector<Firing>{};
  const std::vector<Firing>& firings = firings_.empty() ? own : firings_;
  const std::vector<NearMover> movers =
      moversAround(Stamp{start.nanoseconds + SensorModel::kPeriodNanoseconds / 2});
  Ray ray{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), {-1}};
  Pose T_map_sensor;
  for (std::size_t i = 0; i < firings.size(); ++i) {
    const std::int64_t offset = config_.deskewed ? 0 : firings[i].nanoseconds;
    const Stamp stamp{result.first.nanoseconds + offset};
    if (stamp != ray.stamp) {
      T_map_sensor = route_.poseAt(stamp) * config_.T_base_sensor;
      ray.origin = T_map_sensor.translation;
      ray.stamp = stamp;
    }
    ray.direction = T_map_sensor.rotation * firings[i].direction.cast<double>();
    measure(firings[i], ray, i, movers, result);
  }
  const std::uint32_t last = result.nanoseconds.empty() ? 0U : result.nanoseconds.back();
  result.scan.stamp = {result.first.nanoseconds + last};
  result.scan.T_base_sensor = config_.T_base_sensor;
  for (const std::uint32_t ns : result.nanoseconds) {
    result.scan.times.push_back(
        static_cast<float>(1e-9 * (static_cast<double>(ns) - static_cast<double>(last))));
  }
  return result;
}

}  // namespace revisit_slam::simulation
