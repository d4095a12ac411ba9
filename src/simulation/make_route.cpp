// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "revisit_slam/simulation/random.h"
#include "revisit_slam/simulation/route.h"
#include "revisit_slam/simulation/route_file.h"
#include "revisit_slam/simulation/route_patterns.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kUsualLength = 1000.0;
constexpr double kFileSmoothing = 2.0;
constexpr double kClosestFilePoints = 0.3;
/// The lane changes behind the corner with which a lap begins.
constexpr double kLaneChangeBegins = 12.0;
constexpr double kLaneChange = 30.0;

double usualSpeed(const RouteConfig& config) {
  if (config.motion == MotionKind::kHandheld) return 1.3;
  switch (config.world) {
    case WorldKind::kCampus:
    case WorldKind::kCorridor:
      return 1.5;
    case WorldKind::kAisles:
    case WorldKind::kStoreys:
      return 2.0;
    case WorldKind::kRamp:
    case WorldKind::kBays:
      return 4.0;
    case WorldKind::kMotorway:
      return 25.0;
    default:
      return 8.0;
  }
}

SpeedLimits limitsOf(const RouteConfig& config) {
  SpeedLimits limits;
  limits.speed = config.speed > 0.0 ? config.speed : usualSpeed(config);
  limits.stop_distance = config.stop_and_go ? 120.0 : 0.0;
  limits.seed = config.seed;
  return limits;
}

Polyline roundedAndSampled(const Polyline& line, double sigma) {
  const Polyline dense = resampled(line, 0.5 * Route::kStep);
  return smoothed(dense, 2.0 * sigma / Route::kStep);
}

double offsetAt(const RouteConfig& config, double lap, double arc) {
  const double lane = laneOffset(config.world);
  if (config.route != "lateral") return lane;
  const double u = std::clamp((arc - lap - kLaneChangeBegins) / kLaneChange, 0.0, 1.0);
  return lane - config.lateral_offset * u * u * u * (u * (6.0 * u - 15.0) + 10.0);
}

/// Wider where a lap will be driven on the inner side of a corner.
double cornerSigmaOf(const RouteConfig& config) {
  const double inner = config.route == "lateral" ? 0.7 * config.lateral_offset : 0.0;
  return cornerSigma(config.world) + inner;
}

void layOnGround(Polyline& path, const Terrain& terrain) {
  for (auto& p : path) p.z() = terrain.roadHeight(p.x(), p.y());
}

Route namedRoute(RouteConfig config) {
  if (config.length <= 0.0) config.length = kUsualLength;
  const RoutePattern pattern = makePattern(config);
  Polyline path = roundedAndSampled(pattern.middle, cornerSigmaOf(config));
  const bool has_levels = hasLevels(config.world);
  if (!has_levels) {
    path = movedRight(path, [&](double arc) { return offsetAt(config, pattern.lap, arc); });
    path = smoothed(path, 4.0);
  }
  path = shortened(resampled(path, Route::kStep), config.length);
  auto terrain = std::make_shared<const Terrain>(pattern.layout);
  if (!has_levels) layOnGround(path, *terrain);
  SpeedProfile profile = makeSpeedProfile(path, Route::kStep, limitsOf(config));
  return Route(config, pattern.layout, std::move(terrain), std::move(path), std::move(profile));
}

/// Points that move, with the instants at which they were passed.
RecordedRoute withoutStandstill(const RecordedRoute& recorded) {
  RecordedRoute moving{{recorded.times[0]}, {recorded.positions[0]}};
  for (std::size_t i = 1; i < recorded.times.size(); ++i) {
    const double step = (recorded.positions[i] - moving.positions.back()).head<2>().norm();
    if (step < kClosestFilePoints) continue;
    if (recorded.times[i - 1] > moving.times.back()) {
      moving.times.push_back(recorded.times[i - 1]);
      moving.positions.push_back(moving.positions.back());
    }
    moving.times.push_back(recorded.times[i]);
    moving.positions.push_back(recorded.positions[i]);
  }
  return moving;
}

SpeedProfile recordedProfile(const RecordedRoute& moving, double length, double whole_length) {
  std::vector<double> arcs = arcLengths(moving.positions), times;
  const double scale = whole_length / arcs.back();
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    arcs[i] = std::min(scale * arcs[i], length);
    times.push_back(moving.times[i]);
    if (arcs[i] >= length) break;
  }
  arcs.resize(times.size());
  return profileThrough(times, arcs);
}

Route recordedRoute(const RouteConfig& config) {
  const RecordedRoute moving = withoutStandstill(readRoute(config.route));
  if (moving.times.size() < 2) {
    throw ParameterError("route = '" + config.route + "': does not move");
  }
  Polyline path = resampled(roundedAndSampled(moving.positions, kFileSmoothing), Route::kStep);
  Layout layout{config.world, config.seed, 90.0, 0.0, false};
  auto terrain = std::make_shared<const Terrain>(layout, path);
  const double whole = Route::kStep * static_cast<double>(path.size() - 1);
  const double length = config.length > 0.0 ? std::min(config.length, whole) : whole;
  path = shortened(path, length);
  layOnGround(path, *terrain);
  SpeedProfile profile = config.speed > 0.0 ? makeSpeedProfile(path, Route::kStep, limitsOf(config))
                                            : recordedProfile(moving, length, whole);
  return Route(config, layout, std::move(terrain), std::move(path), std::move(profile));
}

/// Speed and sway are those of the visit.
Route visitOf(const Route& first, RouteConfig config) {
  const VisitConfig& visit = config.visit;
  if (hasLevels(config.world))
    throw ParameterError("visit = " + std::to_string(visit.number) + ": the world " +
                         nameOf(config.world) + " has none");
  config.seed = hashOf(config.seed, 990, static_cast<std::uint64_t>(visit.number));
  const double other_lane = 2.0 * laneOffset(config.world);
  const double left = visit.reversed ? other_lane - visit.aside : visit.aside;
  Polyline path = movedRight(first.path(), [&](double) { return -left; });
  if (visit.reversed) std::reverse(path.begin(), path.end());
  path = resampled(smoothed(path, 4.0), Route::kStep);
  layOnGround(path, first.terrain());
  if (config.speed <= 0.0) config.speed = usualSpeed(config);
  SpeedProfile profile = makeSpeedProfile(path, Route::kStep, limitsOf(config));
  return first.visited(config, std::move(path), std::move(profile));
}

void requireValid(const RouteConfig& config) {
  const auto require = [](bool valid, const std::string& name, double value, const char* allowed) {
    if (!valid) throw ParameterError(name + " = " + std::to_string(value) + ": must be " + allowed);
  };
  require(config.length >= 0.0 && std::isfinite(config.length), "length", config.length,
          "positive");
  require(config.speed >= 0.0 && config.speed <= 40.0, "speed", config.speed,
          "within 0 and 40 m/s");
  require(config.lateral_offset >= 2.0 && config.lateral_offset <= 8.0, "lateral-offset",
          config.lateral_offset, "within 2 and 8 m");
}

}  // namespace

const std::vector<std::string>& routeNames() {
  static const std::vector<std::string> names{"tour",     "loop",         "opposite",    "lateral",
                                              "crossing", "out-and-back", "figure-eight"};
  return names;
}

bool isNamedRoute(const std::string& route) {
  const auto& names = routeNames();
  return std::find(names.begin(), names.end(), route) != names.end();
}

Route makeRoute(const RouteConfig& config) {
  const Route first = worldRoute(config);
  return config.visit.number == 0 ? first : visitOf(first, config);
}

Route worldRoute(RouteConfig config) {
  config.visit = {};
  requireValid(config);
  return isNamedRoute(config.route) ? namedRoute(config) : recordedRoute(config);
}

}  // namespace revisit_slam::simulation
