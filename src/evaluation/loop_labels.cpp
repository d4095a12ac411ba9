// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/loop_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

constexpr double kDegrees = 180.0 / M_PI;
constexpr double kNear = 8.0;
constexpr double kSameLevel = 1.5;
constexpr double kSameLane = 2.0;
constexpr double kFewestMetres = 20.0;
constexpr double kFewestMetresOfCrossing = 10.0;
constexpr double kAroundPlace = 20.0;

struct Approach {
  std::size_t target = 0;
  double distance = std::numeric_limits<double>::infinity();
};

Approach closest(const Eigen::Vector3d& position, const std::vector<Pose>& T_world_target) {
  Approach best;
  for (std::size_t i = 0; i < T_world_target.size(); ++i) {
    const double distance = (T_world_target[i].translation - position).norm();
    if (distance < best.distance) best = {i, distance};
  }
  return best;
}

bool arePassing(const Pose& a, const Pose& b) {
  const Eigen::Vector3d apart = a.translation - b.translation;
  return apart.head<2>().norm() < kNear && std::abs(apart.z()) < kSameLevel;
}

PassKind kindOf(const Pose& T_world_source, const Pose& T_world_target) {
  const Pose T_target_source = T_world_target.inverse() * T_world_source;
  const Eigen::Vector3d ahead = T_target_source.rotation * Eigen::Vector3d::UnitX();
  const double cosine = ahead.x() / ahead.head<2>().norm();
  if (cosine < -std::sqrt(0.5)) return PassKind::opposite;
  if (cosine < std::sqrt(0.5)) return PassKind::crossing;
  return std::abs(T_target_source.translation.y()) < kSameLane ? PassKind::same : PassKind::lateral;
}

/// Where the truth puts the frame of a stretch, by the scans around one of them: their mean, as
/// the pose of a single scan is noisier than the map that many have made.
Pose T_world_map(const Stretch& stretch, std::size_t place) {
  const Eigen::Vector3d centre = stretch.T_world_scan[place].translation;
  const Eigen::Quaterniond about =
      stretch.T_world_scan[place].rotation * stretch.T_map_scan[place].rotation.conjugate();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(), world = turn, map = turn;
  double count = 0.0;
  for (std::size_t i = 0; i < stretch.T_world_scan.size(); ++i) {
    const Pose &T_world = stretch.T_world_scan[i], &T_map = stretch.T_map_scan[i];
    if ((T_world.translation - centre).norm() > kAroundPlace) continue;
    turn += logSO3(about.conjugate() * (T_world.rotation * T_map.rotation.conjugate()));
    world += T_world.translation;
    map += T_map.translation;
    count += 1.0;
  }
  const Eigen::Quaterniond rotation = (about * expSO3(turn / count)).normalized();
  return {rotation, (world - rotation * map) / count};
}

LoopError errorBetween(const Pose& a, const Pose& b, const Eigen::Vector3d& point) {
  return {(a * point - b * point).norm(), kDegrees * (a.inverse() * b).angle()};
}

}  // namespace

const char* toString(PassKind kind) {
  switch (kind) {
    case PassKind::same:
      return "same";
    case PassKind::lateral:
      return "lateral";
    case PassKind::opposite:
      return "opposite";
    case PassKind::crossing:
      return "crossing";
  }
  return "unknown";
}

double LoopLabel::sharedPath() const {
  return std::accumulate(shared.begin(), shared.end(), 0.0);
}

PassKind LoopLabel::kind() const {
  return static_cast<PassKind>(std::max_element(shared.begin(), shared.end()) - shared.begin());
}

bool LoopLabel::isRevisit() const {
  return sharedPath() >= (kind() == PassKind::crossing ? kFewestMetresOfCrossing : kFewestMetres);
}

LoopLabel labelOf(const Stretch& source, const Stretch& target) {
  LoopLabel label;
  label.distance = std::numeric_limits<double>::infinity();
  label.T_keyposes = target.T_world_scan.front().inverse() * source.T_world_scan.front();
  std::size_t source_place = 0, target_place = 0;
  for (std::size_t i = 0; i < source.T_world_scan.size(); ++i) {
    const Pose& here = source.T_world_scan[i];
    const Approach there = closest(here.translation, target.T_world_scan);
    const Pose& other = target.T_world_scan[there.target];
    if (arePassing(here, other) && i > 0)
      label.shared[static_cast<std::size_t>(kindOf(here, other))] +=
          (here.translation - source.T_world_scan[i - 1].translation).norm();
    if (there.distance >= label.distance) continue;
    label.distance = there.distance;
    source_place = i;
    target_place = there.target;
  }
  label.closest_source = source.T_map_scan[source_place].translation;
  label.T_target_source =
      T_world_map(target, target_place).inverse() * T_world_map(source, source_place);
  return label;
}

LoopError errorAtPlace(const Pose& T_target_source, const LoopLabel& label) {
  return errorBetween(T_target_source, label.T_target_source, label.closest_source);
}

LoopError errorAtKeypose(const Pose& T_target_source, const LoopLabel& label) {
  return errorBetween(T_target_source, label.T_keyposes, Eigen::Vector3d::Zero());
}

}  // namespace revisit_slam
