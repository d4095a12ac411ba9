// SPDX-License-Identifier: MIT
#include "traffic.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "car_shapes.h"
#include "revisit_slam/simulation/random.h"
#include "site.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kStep = 0.2;
constexpr double kSecondsPerCar = 12.0;
constexpr double kAppears = 115.0;
constexpr double kLevelHeight = 2.5;
constexpr double kLane = 3.6;

/// Arc on the route over seconds since the start of the drive.
using ArcOverTime = std::function<double(double)>;

struct Drive {
  double from;
  double until;
  ArcOverTime arc;
  /// Metres left of the platform's line; +1 along the route, -1 against it.
  double left;
  double direction;
};

bool isMotorway(const Route& route) {
  return route.layout().kind == WorldKind::kMotorway;
}

Drive oncoming(const Route& route, double meeting, Random& random) {
  const double speed = isMotorway(route) ? random.uniform(20.0, 35.0) : random.uniform(6.0, 13.0);
  const double lane = isMotorway(route) ? kLane * random.integer(-1, 1) : 0.0;
  const double middle = route.arcAt(route.start().plusSeconds(meeting));
  return {meeting - kAppears / speed, meeting + kAppears / speed,
          [=](double t) { return middle - speed * (t - meeting); },
          2.0 * laneOffset(route.layout().kind) - route.visit().aside + lane, -1.0};
}

/// A car that comes near from ahead (or behind), keeps its distance for a while and leaves again.
Drive companion(const Route& route, double middle, double sign, Random& random) {
  const double half = random.uniform(20.0, 40.0), nearest = random.uniform(13.0, 22.0);
  const auto arc = [=, &route](double t) {
    const double u = std::clamp((std::abs(t - middle) / half - 0.4) / 0.6, 0.0, 1.0);
    const double gap = nearest + kAppears * u * u * (3.0 - 2.0 * u);
    return route.arcAt(route.start().plusSeconds(t)) + sign * gap;
  };
  return {middle - half, middle + half, arc, 0.0, 1.0};
}

/// A car in one of the lanes beside, ahead of and behind the platform, about as fast as it.
Drive leader(const Route& route, double gap, double lane, Random& random) {
  const double swing = random.uniform(2.0, 8.0), seconds = random.uniform(15.0, 60.0);
  const double phase = random.uniform(0.0, 6.28);
  const auto arc = [=, &route](double t) {
    return route.arcAt(route.start().plusSeconds(t)) + gap +
           swing * std::sin(phase + 6.28 * t / seconds);
  };
  return {0.0, secondsBetween(route.start(), route.end()), arc, lane, 1.0};
}

Mover carOn(const Route& route, const Drive& drive, int model) {
  std::vector<UniformSpline<6>::Value> states;
  const auto onRoute = [&](double t) {
    const double arc = drive.arc(t);
    return arc > 4.0 && arc < route.length() - 4.0;
  };
  double begin = std::max(0.0, drive.from);
  while (begin < drive.until && !onRoute(begin)) begin += kStep;
  for (double t = begin; t < drive.until && onRoute(t); t += kStep) {
    const Eigen::Vector3d forward = route.directionAt(drive.arc(t));
    const Eigen::Vector3d aside = Eigen::Vector3d(-forward.y(), forward.x(), 0.0).normalized();
    UniformSpline<6>::Value state;
    state << route.positionAt(drive.arc(t)) + drive.left * aside, drive.direction * forward;
    states.push_back(state);
  }
  if (states.size() < 10) return {};
  const Stamp from = route.start().plusSeconds(begin);
  UniformSpline<6> motion(std::move(states), kStep);
  return {model, from, from.plusSeconds(motion.end()), std::move(motion)};
}

Plot plotOf(const Pose& T_map_car, double length, double width) {
  const Eigen::Vector3d forward = T_map_car.rotation * Eigen::Vector3d::UnitX();
  return {{T_map_car.translation, std::atan2(forward.y(), forward.x())}, 0.5 * length, 0.5 * width};
}

bool collide(const Plot& a, const Plot& b) {
  return std::abs(a.centre.origin.z() - b.centre.origin.z()) < kLevelHeight && overlap(a, b);
}

bool isClear(const Route& route, const Mover& car, const std::vector<Mover>& others) {
  const CarSize size = carSize(car.model);
  for (Stamp t = car.from; t <= car.until; t = t.plusSeconds(0.1)) {
    const Plot own = plotOf(car.poseAt(t), size.length + 0.6, size.width + 0.3);
    if (collide(own, plotOf(route.poseAt(t), 5.5, 2.2))) return false;
    for (const Mover& other : others) {
      const CarSize its = carSize(other.model);
      if (!other.isPresent(t)) continue;
      if (collide(own, plotOf(other.poseAt(t), its.length, its.width))) return false;
    }
  }
  return true;
}

/// Those that accompany the platform all the way along a motorway.
std::vector<Mover> makeLeaders(const Route& route) {
  Random random(hashOf(route.layout().seed, 981));
  std::vector<Mover> cars;
  for (const double lane : {-kLane, 0.0, kLane}) {
    for (double gap = -80.0 + random.uniform(0.0, 20.0); gap < 100.0;
         gap += random.uniform(22.0, 40.0)) {
      const Drive drive = leader(route, gap, lane, random);
      Mover car = carOn(route, drive, random.integer(0, carModelCount() - 1));
      if (car.until > car.from && isClear(route, car, cars)) cars.push_back(std::move(car));
    }
  }
  return cars;
}

}  // namespace

std::vector<Mover> makeTraffic(const Route& route, int most) {
  if (most == 0) return {};
  const auto visit = static_cast<std::uint64_t>(route.visit().number);
  Random random(hashOf(route.layout().seed, 980, visit));
  const double duration = secondsBetween(route.start(), route.end());
  const double seconds_per_car = isMotorway(route) ? 3.0 : kSecondsPerCar;
  const int tries = static_cast<int>(duration / seconds_per_car) + 1;
  std::vector<Mover> cars;
  if (isMotorway(route)) cars = makeLeaders(route);
  for (int k = 0; k < tries && static_cast<int>(cars.size()) < most; ++k) {
    const double middle = random.uniform(0.0, duration);
    const double kind = random.uniform(0.0, 1.0);
    const Drive drive = kind < 0.65 || isMotorway(route)
                            ? oncoming(route, middle, random)
                            : companion(route, middle, kind < 0.85 ? 1.0 : -1.0, random);
    Mover car = carOn(route, drive, random.integer(0, carModelCount() - 1));
    if (car.until == car.from || !isClear(route, car, cars)) continue;
    cars.push_back(std::move(car));
  }
  return cars;
}

}  // namespace revisit_slam::simulation
