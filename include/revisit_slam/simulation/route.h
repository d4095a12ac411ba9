// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "revisit_slam/simulation/polyline.h"
#include "revisit_slam/simulation/route_config.h"
#include "revisit_slam/simulation/speed_profile.h"
#include "revisit_slam/simulation/terrain.h"
#include "revisit_slam/simulation/uniform_spline.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam::simulation {

/// The true motion of `base_link`, the point on the ground below the platform, x forward, z up.
/// Position and heading are twice continuously differentiable in time.
class Route {
 public:
  /// @param path on the road's surface, one point every `kStep` metres.
  Route(const RouteConfig& config, const Layout& layout, std::shared_ptr<const Terrain> terrain,
        Polyline path, SpeedProfile profile);

  /// T_map_base; before the start and after the end the platform stands.
  Pose poseAt(Stamp stamp) const;
  Stamp start() const { return config_.start; }
  Stamp end() const { return config_.start.plusSeconds(profile_.end()); }
  /// Metres along the road.
  double length() const { return path_.end(); }
  double speedAt(Stamp stamp) const;

  /// Metres from the start of the path, and the road below that place.
  double arcAt(Stamp stamp) const;
  Eigen::Vector3d positionAt(double arc) const { return path_.value(arc); }
  Eigen::Vector3d directionAt(double arc) const;

  /// The path every `kStep` metres.
  const Polyline& path() const { return path_.controls(); }
  const Layout& layout() const { return layout_; }
  const Terrain& terrain() const { return *terrain_; }
  const VisitConfig& visit() const { return config_.visit; }

  /// Another drive over the same terrain.
  Route visited(const RouteConfig& config, Polyline path, SpeedProfile profile) const {
    return {config, layout_, terrain_, std::move(path), std::move(profile)};
  }

  static constexpr double kStep = 0.5;

 private:
  Pose roadPose(double arc) const;

  RouteConfig config_;
  Layout layout_;
  std::shared_ptr<const Terrain> terrain_;
  UniformSpline<3> path_;
  SpeedProfile profile_;
};

/// From a name or a file; of a visit the drive itself, whose world is that of worldRoute().
/// @throw ParameterError naming the option and its value.
Route makeRoute(const RouteConfig& config);
/// The drive that the world was laid around. @throw likewise.
Route worldRoute(RouteConfig config);

}  // namespace revisit_slam::simulation
