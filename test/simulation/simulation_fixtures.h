// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/simulation/drive.h"

namespace revisit_slam::simulation {

inline RouteConfig shortDrive(const std::string& route = "tour", double length = 400.0) {
  RouteConfig config;
  config.route = route;
  config.length = length;
  return config;
}

/// A flat floor and a wall at x = 10 that faces the origin, both 200 m wide.
inline World wallAhead() {
  World world;
  world.still.vertices = {{10, -100, -5},  {10, 100, -5}, {10, 100, 50}, {10, -100, 50},
                          {-100, -100, 0}, {10, -100, 0}, {10, 100, 0},  {-100, 100, 0}};
  world.still.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  world.still.materials = {Material::kPlaster, Material::kPlaster, Material::kAsphalt,
                           Material::kAsphalt};
  return world;
}

/// Straight along x on flat ground at a steady speed from x = 0, with the motion of a handheld
/// sensor where asked for.
inline Route straightRoute(double speed, double length, MotionKind motion = MotionKind::kVehicle) {
  RouteConfig config;
  config.motion = motion;
  Layout layout;
  layout.kind = WorldKind::kCorridor;
  Polyline path;
  for (double x = 0.0; x <= length; x += Route::kStep) path.emplace_back(x, 0.0, 0.0);
  std::vector<double> times, arcs;
  for (double t = 0.0; t * speed <= length; t += 0.1) {
    times.push_back(t);
    arcs.push_back(speed * t);
  }
  return Route(config, layout, std::make_shared<const Terrain>(layout), path,
               profileThrough(times, arcs));
}

}  // namespace revisit_slam::simulation
