// SPDX-License-Identifier: MIT
#include <algorithm>

#include "buildings.h"
#include "facade.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kPi = 3.141592653589793;

/// A box of a house with its own walls: half extents and height.
struct Wing {
  Placement centre;
  double half_length;
  double half_width;
  double height;
};

void addWalls(TriangleMesh& mesh, const Wing& wing, const FacadeStyle& style, Random& random) {
  const double l = wing.half_length, w = wing.half_width;
  const auto wall = [&](double x, double y, double turn, double width) {
    addFacade(mesh, wing.centre.moved(x, y, 0.0, turn), width, wing.height, style, random);
  };
  // Facades look along their y axis, so their x axis runs clockwise around the house.
  wall(l, -w, kPi, 2.0 * l);
  wall(-l, -w, 0.5 * kPi, 2.0 * w);
  wall(-l, w, 0.0, 2.0 * l);
  wall(l, w, -0.5 * kPi, 2.0 * w);
}

void addFlatRoof(TriangleMesh& mesh, const Wing& wing, Random& random) {
  const double l = wing.half_length + 0.15, w = wing.half_width + 0.15, h = wing.height;
  addBox(mesh, wing.centre, {-l, -w, h}, {l, w, h + 0.25}, Material::kRoof);
  const double parapet = h + random.uniform(0.3, 1.0);
  addBox(mesh, wing.centre, {-l, -w, h}, {l, -w + 0.25, parapet}, Material::kConcrete);
  addBox(mesh, wing.centre, {-l, w - 0.25, h}, {l, w, parapet}, Material::kConcrete);
}

/// Two slopes that meet in a ridge along x; `hip` draws the ends of the ridge in.
void addPitchedRoof(TriangleMesh& mesh, const Wing& wing, double hip, const FacadeStyle& style,
                    Random& random) {
  const double over = random.uniform(0.25, 0.7);
  const double l = wing.half_length + over, w = wing.half_width + over, h = wing.height - 0.1;
  const double ridge = h + wing.half_width * random.uniform(0.5, 1.0);
  const Placement& at = wing.centre;
  const Eigen::Vector3d left = at.at(-l + hip, 0.0, ridge), right = at.at(l - hip, 0.0, ridge);
  addQuad(mesh, at.at(-l, -w, h), at.at(l, -w, h), right, left, Material::kRoof);
  addQuad(mesh, at.at(-l, w, h), at.at(l, w, h), right, left, Material::kRoof);
  for (const double end : {-1.0, 1.0}) {
    const double x = end * (hip > 0.0 ? l : wing.half_length);
    const double y = hip > 0.0 ? w : wing.half_width;
    addTriangle(mesh, at.at(x, -y, h), at.at(x, y, h), end < 0.0 ? left : right,
                hip > 0.0 ? Material::kRoof : style.wall);
  }
  const double x = random.uniform(-0.7, 0.7) * wing.half_length;
  const double y = random.uniform(-0.5, 0.5) * wing.half_width;
  addBox(mesh, at, {x - 0.35, y - 0.35, h}, {x + 0.35, y + 0.35, ridge + 0.8}, Material::kBrick);
}

void addWing(TriangleMesh& mesh, const Wing& wing, const FacadeStyle& style, Random& random) {
  addWalls(mesh, wing, style, random);
  if (wing.half_width > 8.0 || random.chance(0.35)) {
    addFlatRoof(mesh, wing, random);
  } else {
    const double hip = random.chance(0.35) ? 0.6 * wing.half_length : 0.0;
    addPitchedRoof(mesh, wing, hip, style, random);
  }
}

}  // namespace

void addHouse(TriangleMesh& mesh, const Plot& plot, double height, Random& random) {
  const FacadeStyle style = randomFacadeStyle(random);
  const double l = plot.half_length, w = plot.half_width;
  if (l < 5.0 || random.chance(0.5)) {
    addWing(mesh, {plot.centre, l, w, height}, style, random);
    return;
  }
  // An L: the front wing is wide, the rear or side wing lower and narrower.
  const double front = w * random.uniform(0.5, 0.7);
  const double side = l * random.uniform(0.3, 0.5);
  const double end = random.sign();
  addWing(mesh, {plot.centre.moved(0.0, -w + front, 0.0), l, front, height}, style, random);
  addWing(mesh,
          {plot.centre.moved(end * (l - side), front, 0.0), side, w - front,
           height * random.uniform(0.5, 0.95)},
          style, random);
}

}  // namespace revisit_slam::simulation
