// SPDX-License-Identifier: MIT
#include "facade.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam::simulation {
namespace {

constexpr double kFoundation = 1.5;

/// A rectangle of the wall plane.
struct Panel {
  double x0, x1, z0, z1;
};

void addFlat(TriangleMesh& mesh, const Placement& wall, const Panel& p, double y,
             Material material) {
  addQuad(mesh, wall.at(p.x0, y, p.z0), wall.at(p.x1, y, p.z0), wall.at(p.x1, y, p.z1),
          wall.at(p.x0, y, p.z1), material);
}

/// The panel with a hole, the reveals of the hole and what closes it `depth` behind the wall.
void addOpening(TriangleMesh& mesh, const Placement& wall, const Panel& panel, const Panel& hole,
                double depth, const FacadeStyle& style, Material filling) {
  addFlat(mesh, wall, {panel.x0, hole.x0, panel.z0, panel.z1}, 0.0, style.wall);
  addFlat(mesh, wall, {hole.x1, panel.x1, panel.z0, panel.z1}, 0.0, style.wall);
  addFlat(mesh, wall, {hole.x0, hole.x1, panel.z0, hole.z0}, 0.0, style.wall);
  addFlat(mesh, wall, {hole.x0, hole.x1, hole.z1, panel.z1}, 0.0, style.wall);
  addFlat(mesh, wall, hole, -depth, filling);
  const auto reveal = [&](double xa, double za, double xb, double zb) {
    addQuad(mesh, wall.at(xa, 0.0, za), wall.at(xb, 0.0, zb), wall.at(xb, -depth, zb),
            wall.at(xa, -depth, za), style.wall);
  };
  reveal(hole.x0, hole.z0, hole.x0, hole.z1);
  reveal(hole.x1, hole.z0, hole.x1, hole.z1);
  reveal(hole.x0, hole.z0, hole.x1, hole.z0);
  reveal(hole.x0, hole.z1, hole.x1, hole.z1);
}

void addBalcony(TriangleMesh& mesh, const Placement& wall, const Panel& panel, Random& random) {
  const double depth = random.uniform(0.9, 1.4), x0 = panel.x0 + 0.2, x1 = panel.x1 - 0.2;
  const double z = panel.z0 + 0.05;
  addBox(mesh, wall, {x0, 0.0, z - 0.15}, {x1, depth, z}, Material::kConcrete);
  addBox(mesh, wall, {x0, depth - 0.06, z}, {x1, depth, z + 1.0}, Material::kMetal);
  addBox(mesh, wall, {x0, 0.0, z}, {x0 + 0.05, depth, z + 1.0}, Material::kMetal);
  addBox(mesh, wall, {x1 - 0.05, 0.0, z}, {x1, depth, z + 1.0}, Material::kMetal);
}

Panel windowIn(const Panel& panel, const FacadeStyle& style) {
  const double middle = 0.5 * (panel.x0 + panel.x1);
  const double half = 0.5 * std::min(style.window_width, 0.8 * (panel.x1 - panel.x0));
  const double z0 = panel.z0 + style.sill;
  return {middle - half, middle + half, z0, std::min(z0 + style.window_height, panel.z1 - 0.2)};
}

void addDoor(TriangleMesh& mesh, const Placement& wall, const Panel& panel,
             const FacadeStyle& style) {
  const double middle = 0.5 * (panel.x0 + panel.x1);
  const Panel hole{middle - 0.55, middle + 0.55, panel.z0, panel.z0 + 2.1};
  addOpening(mesh, wall, panel, hole, 0.35, style, Material::kPaint);
  addBox(mesh, wall, {middle - 0.8, 0.0, panel.z0 - 0.5}, {middle + 0.8, 1.0, panel.z0 + 0.02},
         Material::kConcrete);
  addBox(mesh, wall, {middle - 0.9, 0.0, panel.z0 + 2.3}, {middle + 0.9, 0.9, panel.z0 + 2.4},
         Material::kConcrete);
}

}  // namespace

FacadeStyle randomFacadeStyle(Random& random) {
  FacadeStyle style;
  style.bay = random.uniform(2.4, 4.2);
  style.storey = random.uniform(2.7, 3.4);
  style.window_width = random.uniform(0.9, 1.9);
  style.window_height = random.uniform(1.1, 1.8);
  style.sill = random.uniform(0.5, 1.0);
  style.recess = random.uniform(0.08, 0.35);
  style.balcony_share = random.chance(0.4) ? random.uniform(0.2, 0.6) : 0.0;
  style.bay_window_share = random.chance(0.3) ? 0.35 : 0.0;
  style.pilaster_share = random.chance(0.3) ? 0.7 : 0.05;
  style.wall = random.chance(0.45) ? Material::kBrick : Material::kPlaster;
  return style;
}

void addFacade(TriangleMesh& mesh, const Placement& wall, double width, double height,
               const FacadeStyle& style, Random& random) {
  const int bays = std::max(1, static_cast<int>(std::lround(width / style.bay)));
  const int storeys = std::max(1, static_cast<int>(std::lround(height / style.storey)));
  const double bay = width / bays, storey = height / storeys;
  const int door = random.integer(0, bays - 1);
  for (int i = 0; i < bays; ++i) {
    const bool protruding = bays > 2 && random.chance(style.bay_window_share);
    const bool balconies = !protruding && random.chance(style.balcony_share);
    const double forward = protruding ? random.uniform(0.4, 0.9) : 0.0;
    const Placement front = wall.moved(0.0, forward, 0.0);
    for (int k = 0; k < storeys; ++k) {
      const Panel panel{i * bay, (i + 1) * bay, k * storey, (k + 1) * storey};
      if (k == 0 && i == door) {
        addDoor(mesh, front, panel, style);
      } else if (random.chance(0.06)) {
        addFlat(mesh, front, panel, 0.0, style.wall);
      } else {
        const Material filling = random.chance(0.3) ? Material::kPaint : Material::kGlass;
        addOpening(mesh, front, panel, windowIn(panel, style), style.recess, style, filling);
      }
      if (k > 0 && balconies) addBalcony(mesh, front, panel, random);
    }
    if (protruding) {
      addFlat(mesh, wall.moved(i * bay, 0.0, 0.0, 1.5707963), {0.0, forward, 0.0, height}, 0.0,
              style.wall);
      addFlat(mesh, wall.moved((i + 1) * bay, 0.0, 0.0, 1.5707963), {0.0, forward, 0.0, height},
              0.0, style.wall);
      addBox(mesh, wall, {i * bay, 0.0, height - 0.1}, {(i + 1) * bay, forward, height},
             Material::kRoof);
    }
    addFlat(mesh, front, {i * bay, (i + 1) * bay, -kFoundation, 0.0}, 0.0, Material::kConcrete);
    if (random.chance(style.pilaster_share)) {
      addBox(mesh, wall, {i * bay - 0.2, 0.0, -kFoundation}, {i * bay + 0.2, 0.18, height},
             style.wall);
    }
  }
}

}  // namespace revisit_slam::simulation
