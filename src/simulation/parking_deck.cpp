// SPDX-License-Identifier: MIT
#include <cmath>

#include "car_shapes.h"
#include "ramp_shape.h"
#include "revisit_slam/simulation/random.h"
#include "structures.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kHalfWay = 2.5;
constexpr double kSlab = 0.25;
constexpr double kParapet = 1.0;

void addWay(TriangleMesh& mesh, const Polyline& way) {
  const Polyline line = resampled(way, 1.0);
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    if (line[k].z() < 0.03) continue;
    const auto edge = [&](std::size_t i, double side, double up) -> Eigen::Vector3d {
      const Eigen::Vector2d along = directionAt(line, i);
      return line[i] +
             Eigen::Vector3d(-along.y() * side * kHalfWay, along.x() * side * kHalfWay, up);
    };
    addQuad(mesh, edge(k, -1, 0), edge(k + 1, -1, 0), edge(k + 1, 1, 0), edge(k, 1, 0),
            Material::kConcrete);
    addQuad(mesh, edge(k, -1, -kSlab), edge(k + 1, -1, -kSlab), edge(k + 1, 1, -kSlab),
            edge(k, 1, -kSlab), Material::kConcrete);
    for (const double side : {-1.0, 1.0}) {
      const double top = line[k].z() > 0.4 ? kParapet : 0.1;
      addQuad(mesh, edge(k, side, -kSlab), edge(k + 1, side, -kSlab), edge(k + 1, side, top),
              edge(k, side, top), Material::kConcrete);
      const double outer = side * 1.06;
      addQuad(mesh, edge(k, outer, -kSlab), edge(k + 1, outer, -kSlab), edge(k + 1, outer, top),
              edge(k, outer, top), Material::kConcrete);
    }
  }
}

void addHelixColumns(TriangleMesh& mesh, const RampShape& shape) {
  const Eigen::Vector3d centre(shape.centre.x(), shape.centre.y(), -0.2);
  const double top = shape.deckHeight() + 4.0;
  addCylinder(mesh, centre, centre + Eigen::Vector3d(0, 0, top), 4.0, 4.0, 24, Material::kConcrete);
  for (int k = 0; k < 9; ++k) {
    const double angle = 0.35 + 0.698 * k;
    const double radius = 0.5 * (shape.up_radius + shape.down_radius);
    const Eigen::Vector3d foot =
        centre + Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0);
    addCylinder(mesh, foot, foot + Eigen::Vector3d(0, 0, shape.deckHeight()), 0.22, 0.22, 8,
                Material::kConcrete);
  }
}

void addUpperDeck(TriangleMesh& mesh, const RampShape& shape) {
  const Eigen::Vector2d a = shape.deck_low, b = shape.deck_high;
  const double h = shape.deckHeight();
  const Placement origin;
  const double gap_low = shape.centre.y() - shape.down_radius - kHalfWay, gap_high = kHalfWay;
  addBox(mesh, origin, {a.x(), a.y(), h - kSlab}, {b.x(), b.y(), h}, Material::kConcrete);
  addBox(mesh, origin, {a.x(), a.y(), h}, {b.x(), a.y() + 0.2, h + kParapet}, Material::kConcrete);
  addBox(mesh, origin, {a.x(), b.y() - 0.2, h}, {b.x(), b.y(), h + kParapet}, Material::kConcrete);
  addBox(mesh, origin, {b.x() - 0.2, a.y(), h}, {b.x(), b.y(), h + kParapet}, Material::kConcrete);
  addBox(mesh, origin, {a.x(), a.y(), h}, {a.x() + 0.2, gap_low, h + kParapet},
         Material::kConcrete);
  addBox(mesh, origin, {a.x(), gap_high, h}, {a.x() + 0.2, b.y(), h + kParapet},
         Material::kConcrete);
  addBox(mesh, origin, {50.0, 18.0, h}, {56.0, 24.0, h + 3.0}, Material::kPlaster);
}

void addColumns(Site& site, const RampShape& shape) {
  for (double x = shape.deck_low.x() + 4.0; x < shape.deck_high.x(); x += 8.0) {
    for (double y = shape.deck_low.y() + 3.0; y < shape.deck_high.y(); y += 8.0) {
      if (site.fromRoute({x, y}) < 2.2) continue;
      addBox(site.mesh(), {{x, y, 0.0}, 0.0}, {-0.3, -0.3, -0.2},
             {0.3, 0.3, shape.deckHeight() - kSlab}, Material::kConcrete);
    }
  }
}

void addStandingCars(Site& site, const RampShape& shape) {
  Random random(hashOf(site.layout().seed, 960));
  for (const double z : {0.0, shape.deckHeight()}) {
    for (double y = shape.deck_low.y() + 4.0; y < shape.deck_high.y() - 3.0; y += 6.0) {
      for (double x = shape.deck_low.x() + 5.0; x < shape.deck_high.x() - 4.0; x += 2.9) {
        if (!random.chance(0.4) || site.fromRoute({x, y}) < 4.5) continue;
        addCar(site.mesh(), {{x, y, z}, 1.5708 * random.sign() + random.uniform(-0.05, 0.05)},
               random.integer(0, carModelCount() - 1));
      }
    }
  }
}

}  // namespace

void addParkingDeck(Site& site) {
  const RampShape shape = rampShape(site.route().length());
  addWay(site.mesh(), wayUp(shape));
  addWay(site.mesh(), wayDown(shape));
  addHelixColumns(site.mesh(), shape);
  addUpperDeck(site.mesh(), shape);
  addColumns(site, shape);
  addStandingCars(site, shape);
  for (double x = -24.0; x < shape.deck_high.x(); x += 16.0) {
    for (double y = shape.deck_low.y(); y < shape.deck_high.y(); y += 16.0) {
      site.occupy({{{x + 8.0, y + 8.0, 0.0}, 0.0}, 8.0, 8.0});
    }
  }
}

}  // namespace revisit_slam::simulation
