// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/route.h"

#include <cmath>
#include <utility>

#include "revisit_slam/simulation/body_motion.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kHalfTrack = 0.8;

}  // namespace

Route::Route(const RouteConfig& config, const Layout& layout,
             std::shared_ptr<const Terrain> terrain, Polyline path, SpeedProfile profile)
    : config_(config),
      layout_(layout),
      terrain_(std::move(terrain)),
      path_(std::move(path), kStep),
      profile_(std::move(profile)) {}

double Route::arcAt(Stamp stamp) const {
  return profile_.value(secondsBetween(config_.start, stamp)).value();
}

double Route::speedAt(Stamp stamp) const {
  return profile_.derivative(secondsBetween(config_.start, stamp)).value();
}

Eigen::Vector3d Route::directionAt(double arc) const {
  return path_.derivative(arc).normalized();
}

Pose Route::roadPose(double arc) const {
  const Eigen::Vector3d position = path_.value(arc);
  const Eigen::Vector3d forward = directionAt(arc);
  const Eigen::Vector2d left = Eigen::Vector2d(-forward.y(), forward.x()).normalized();
  const auto height = [&](double offset) {
    return terrain_->roadHeight(position.x() + offset * left.x(), position.y() + offset * left.y());
  };
  const double slope = (height(kHalfTrack) - height(-kHalfTrack)) / (2.0 * kHalfTrack);
  Eigen::Matrix3d axes;
  axes.col(0) = forward;
  axes.col(2) = forward.cross(Eigen::Vector3d(left.x(), left.y(), slope)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return {Eigen::Quaterniond(axes), position};
}

Pose Route::poseAt(Stamp stamp) const {
  const double time = secondsBetween(config_.start, stamp);
  return roadPose(arcAt(stamp)) * bodyMotion(config_.motion, config_.seed, time, speedAt(stamp));
}

}  // namespace revisit_slam::simulation
