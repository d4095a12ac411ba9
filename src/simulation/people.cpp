// SPDX-License-Identifier: MIT
#include "people.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "revisit_slam/simulation/random.h"
#include "revisit_slam/simulation/ray_caster.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kStep = 0.2;          // s, between the states of a walk
constexpr double kShortestWalk = 5.0;  // s
/// m/s, of somebody on the inner or outer side of a bend.
constexpr double kSlowest = 0.5, kFastest = 2.2;
constexpr double kElbowRoom = 0.35;  // m, from the middle of a person
/// Half of what the platform needs, with a margin, m.
constexpr double kPlatformAhead = 2.0, kPlatformBeside = 1.4;

struct PersonModel {
  double height, stride;  // m
};
constexpr std::array<PersonModel, 4> kModels{{{1.62, 0.55}, {1.72, 0.3}, {1.80, 0.65}, {1.3, 0.4}}};

/// Where somebody is, in the plane, over seconds since the start of the drive.
using PlaceOverTime = std::function<Eigen::Vector2d(double)>;

struct Walk {
  double middle, half;  // s
  PlaceOverTime place;
};

Eigen::Vector2d leftOf(const Eigen::Vector3d& forward) {
  return Eigen::Vector2d(-forward.y(), forward.x()).normalized();
}

/// Beside the platform's line, in its direction or towards it, weaving a little.
Walk along(const Route& route, double middle, Random& random) {
  const double speed = random.sign() * random.uniform(0.8, 1.7);
  const double aside = random.sign() * random.uniform(1.6, 7.0);
  const double weave = random.uniform(0.0, 0.4), phase = random.uniform(0.0, 6.28);
  const double meeting = route.arcAt(route.start().plusSeconds(middle)) + random.uniform(-8.0, 8.0);
  return {middle, random.uniform(10.0, 25.0), [=, &route](double t) -> Eigen::Vector2d {
            const double arc = std::clamp(meeting + speed * (t - middle), 0.0, route.length());
            return route.positionAt(arc).head<2>() +
                   (aside + weave * std::sin(phase + 0.6 * t)) * leftOf(route.directionAt(arc));
          }};
}

/// Across the platform's line, before or behind it.
Walk across(const Route& route, double middle, Random& random) {
  const double speed = random.uniform(0.8, 1.7), turn = random.uniform(-0.6, 0.6);
  const double from = route.arcAt(route.start().plusSeconds(middle));
  const double arc = std::clamp(from + random.uniform(-12.0, 20.0), 0.0, route.length());
  const Eigen::Vector2d crossing = route.positionAt(arc).head<2>();
  const Eigen::Vector2d way =
      random.sign() * (Eigen::Rotation2Dd(turn) * leftOf(route.directionAt(arc)));
  return {middle, random.uniform(6.0, 14.0),
          [=](double t) -> Eigen::Vector2d { return crossing + speed * (t - middle) * way; }};
}

bool isInTheWay(const Route& route, const Eigen::Vector2d& place, double t) {
  const Pose T_map_base = route.poseAt(route.start().plusSeconds(t));
  const Eigen::Vector3d apart =
      T_map_base.inverse() * Eigen::Vector3d(place.x(), place.y(), T_map_base.translation.z());
  return std::abs(apart.x()) < kPlatformAhead && std::abs(apart.y()) < kPlatformBeside;
}

bool isWalking(double speed) {
  return speed > kSlowest && speed < kFastest;
}

/// Whether nothing higher than a kerb is within arm's reach, seen from above.
bool standsClear(const RayCaster& still, const Eigen::Vector3d& feet) {
  constexpr double above = 2.0, kerb = 0.25;
  for (const double x : {-kElbowRoom, 0.0, kElbowRoom})
    for (const double y : {-kElbowRoom, 0.0, kElbowRoom})
      if (still.cast(feet + Eigen::Vector3d(x, y, above), -Eigen::Vector3d::UnitZ(), above - kerb))
        return false;
  return true;
}

/// The piece of the walk around its middle on which nothing is in its way.
Mover walker(const Site& site, const RayCaster& still, const Route& route, const Walk& walk,
             int model) {
  const double duration = secondsBetween(route.start(), route.end());
  const auto is_free = [&](double t) {
    const Eigen::Vector2d p = walk.place(t);
    constexpr double anywhere = -1e3;  // also on the way
    return t >= 0.0 && t <= duration && isWalking((walk.place(t + kStep) - p).norm() / kStep) &&
           !isInTheWay(route, p, t) && standsClear(still, {p.x(), p.y(), site.ground(p)}) &&
           site.isFree({{{p.x(), p.y(), 0.0}, 0.0}, kElbowRoom, kElbowRoom}, anywhere);
  };
  double begin = walk.middle, end = walk.middle;
  while (begin - kStep > walk.middle - walk.half && is_free(begin - kStep)) begin -= kStep;
  while (end + kStep < walk.middle + walk.half && is_free(end + kStep)) end += kStep;
  if (!is_free(walk.middle) || end - begin < kShortestWalk) return {};
  std::vector<UniformSpline<6>::Value> states;
  const int steps = static_cast<int>(std::lround((end - begin) / kStep));
  for (int k = 0; k <= steps; ++k) {
    const double t = begin + k * kStep;
    const Eigen::Vector2d p = walk.place(t);
    const Eigen::Vector2d forward = (walk.place(t + kStep) - walk.place(t - kStep)).normalized();
    UniformSpline<6>::Value state;
    state << p.x(), p.y(), site.ground(p), forward.x(), forward.y(), 0.0;
    states.push_back(state);
  }
  const Stamp from = route.start().plusSeconds(begin);
  UniformSpline<6> motion(std::move(states), kStep);
  return {model, from, from.plusSeconds(motion.end()), std::move(motion)};
}

}  // namespace

int personModelCount() {
  return static_cast<int>(kModels.size());
}

void addPerson(TriangleMesh& mesh, int model) {
  const auto [height, stride] = kModels[static_cast<std::size_t>(model)];
  const double hip = 0.5 * height, neck = 0.84 * height;
  const auto limb = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to, double thick,
                        double thin) {
    addCylinder(mesh, from, to, thick, thin, 8, Material::kCloth);
  };
  for (const double side : {-1.0, 1.0}) {
    limb({side * 0.5 * stride, side * 0.1, 0.0}, {0.0, side * 0.09, hip}, 0.06, 0.09);
    limb({-side * 0.4 * stride, side * 0.26, hip}, {0.0, side * 0.2, neck}, 0.04, 0.06);
  }
  limb({0.0, 0.0, 0.95 * hip}, {0.0, 0.0, neck}, 0.16, 0.19);
  limb({0.0, 0.0, neck}, {0.0, 0.0, height}, 0.09, 0.1);
}

std::vector<Mover> makePeople(Site& site, const Route& visit, int most, int first_model) {
  if (most == 0) return {};
  const RayCaster still(site.mesh());
  Random random(hashOf(site.layout().seed, 990, static_cast<std::uint64_t>(visit.visit().number)));
  const double duration = secondsBetween(visit.start(), visit.end());
  constexpr int tries_each = 4;
  std::vector<Mover> people;
  for (int k = 0; k < tries_each * most && static_cast<int>(people.size()) < most; ++k) {
    const double middle = random.uniform(0.0, duration);
    const Walk walk =
        random.chance(0.65) ? along(visit, middle, random) : across(visit, middle, random);
    const int model = first_model + random.integer(0, personModelCount() - 1);
    Mover person = walker(site, still, visit, walk, model);
    if (person.until > person.from) people.push_back(std::move(person));
  }
  return people;
}

}  // namespace revisit_slam::simulation
