// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/revisits.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam::simulation {
namespace {

constexpr double kNear = 8.0;
constexpr double kSameLevel = 1.5;
constexpr double kLeastSeconds = 30.0;
constexpr double kLeastMetres = 50.0;
constexpr double kSameLane = 2.0;
constexpr double kStep = 1.0;
constexpr double kLargestJump = 12.0;

struct Place {
  double arc;
  Stamp stamp;
  Eigen::Vector3d position;
  Eigen::Vector2d direction;
};

struct Match {
  double earlier_arc;
  Revisit revisit;
};

/// A place about every metre, in the order of the drive.
std::vector<Place> places(const Route& route) {
  std::vector<Place> result;
  double next = 0.0;
  for (Stamp t = route.start(); t <= route.end(); t = t.plusSeconds(0.02)) {
    const double arc = route.arcAt(t);
    if (arc < next) continue;
    next = arc + kStep;
    result.push_back(
        {arc, t, route.positionAt(arc), route.directionAt(arc).head<2>().normalized()});
  }
  return result;
}

bool isRevisit(const Place& earlier, const Place& later) {
  const Eigen::Vector3d apart = later.position - earlier.position;
  return apart.head<2>().norm() < kNear && std::abs(apart.z()) < kSameLevel &&
         later.arc - earlier.arc > kLeastMetres &&
         secondsBetween(earlier.stamp, later.stamp) > kLeastSeconds;
}

RevisitKind kindOf(const Place& earlier, const Place& later) {
  const double cosine = earlier.direction.dot(later.direction);
  if (cosine < -std::sqrt(0.5)) return RevisitKind::kOpposite;
  if (cosine < std::sqrt(0.5)) return RevisitKind::kCrossing;
  const Eigen::Vector2d apart = (later.position - earlier.position).head<2>();
  const double aside = earlier.direction.x() * apart.y() - earlier.direction.y() * apart.x();
  return std::abs(aside) < kSameLane ? RevisitKind::kSame : RevisitKind::kLateral;
}

/// For each earlier pass, the place of it that is nearest.
std::vector<const Place*> nearestOfEachPass(const std::vector<Place>& all, const Place& later) {
  std::vector<const Place*> result;
  double previous_arc = -1e9;
  for (const Place& earlier : all) {
    if (later.arc - earlier.arc <= kLeastMetres) break;
    if (!isRevisit(earlier, later)) continue;
    const auto distance = [&](const Place& p) {
      return (p.position - later.position).squaredNorm();
    };
    if (earlier.arc - previous_arc > kLargestJump) {
      result.push_back(&earlier);
    } else if (distance(earlier) < distance(*result.back())) {
      result.back() = &earlier;
    }
    previous_arc = earlier.arc;
  }
  return result;
}

bool extends(const Match& match, const Place& earlier, const Place& later, RevisitKind kind) {
  return match.revisit.kind == kind && std::abs(match.earlier_arc - earlier.arc) < kLargestJump &&
         secondsBetween(match.revisit.later_until, later.stamp) < 3.0;
}

void addTo(std::vector<Match>& matches, const Place& earlier, const Place& later) {
  const RevisitKind kind = kindOf(earlier, later);
  for (auto match = matches.rbegin(); match != matches.rend(); ++match) {
    if (!extends(*match, earlier, later, kind)) continue;
    Revisit& revisit = match->revisit;
    revisit.later_until = later.stamp;
    revisit.earlier_from = std::min(revisit.earlier_from, earlier.stamp);
    revisit.earlier_until = std::max(revisit.earlier_until, earlier.stamp);
    match->earlier_arc = earlier.arc;
    return;
  }
  matches.push_back({earlier.arc, {kind, earlier.stamp, earlier.stamp, later.stamp, later.stamp}});
}

}  // namespace

std::string nameOf(RevisitKind kind) {
  switch (kind) {
    case RevisitKind::kSame:
      return "same";
    case RevisitKind::kOpposite:
      return "opposite";
    case RevisitKind::kLateral:
      return "lateral";
    case RevisitKind::kCrossing:
      return "crossing";
  }
  return "same";
}

std::vector<Revisit> findRevisits(const Route& route) {
  const std::vector<Place> all = places(route);
  std::vector<Match> matches;
  for (const Place& later : all) {
    for (const Place* earlier : nearestOfEachPass(all, later)) addTo(matches, *earlier, later);
  }
  std::vector<Revisit> revisits;
  for (const Match& match : matches) revisits.push_back(match.revisit);
  return revisits;
}

}  // namespace revisit_slam::simulation
