// SPDX-License-Identifier: MIT
#include <cmath>

#include "roadside.h"
#include "structures.h"
#include "vegetation.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kStretch = 180.0;
constexpr double kBareRadius = 60.0;
constexpr int kPostSpacing = 4;

/// Stretches of some hundred metres along which only the ground is near. None where the drive
/// begins: what accelerates together with the platform is else all there is.
bool isBare(const Site& site, const Eigen::Vector2d& p) {
  const Eigen::Vector2d start = site.route().path().front().head<2>();
  if ((p - start).norm() < kStretch) return false;
  return smoothNoise(site.layout().seed + 7400, p.x() / kStretch, p.y() / kStretch) > -0.05;
}

void addGuardRails(Site& site) {
  const Road& road = site.roads().front();
  const Polyline line = resampled(road.middle, 1.0);
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Eigen::Vector2d along = directionAt(line, k), p = line[k].head<2>();
    if (isBare(site, p)) continue;
    const Placement at{{p.x(), p.y(), site.ground(p)}, std::atan2(along.y(), along.x())};
    addBox(site.mesh(), at, {-0.02, -0.25, -0.2}, {1.02, 0.25, 0.85}, Material::kConcrete);
    for (const double side : {-1.0, 1.0}) {
      const double y = side * (road.half_width + 0.3);
      addBox(site.mesh(), at, {-0.02, y - 0.04, 0.45}, {1.02, y + 0.04, 0.75}, Material::kMetal);
      if (k % kPostSpacing == 0)
        addBox(site.mesh(), at, {-0.06, y - 0.06, -0.5}, {0.06, y + 0.06, 0.7}, Material::kMetal);
    }
  }
}

void addBoard(TriangleMesh& mesh, const Placement& at, double half) {
  for (const double x : {-0.8 * half, 0.8 * half})
    addCylinder(mesh, at.at(0, x, -0.5), at.at(0, x, 4.0), 0.08, 0.08, 6, Material::kMetal);
  addBox(mesh, at, {-0.04, -half, 1.8}, {0.04, half, 4.2}, Material::kSignFace);
}

/// From the roadside at `at` across the whole road.
void addGantry(TriangleMesh& mesh, const Placement& at, double width) {
  for (const double y : {0.0, -width})
    addBox(mesh, at, {-0.25, y - 0.25, -0.5}, {0.25, y + 0.25, 6.8}, Material::kMetal);
  addBox(mesh, at, {-0.3, -width, 6.2}, {0.3, 0.0, 6.8}, Material::kMetal);
  for (const double share : {0.2, 0.4, 0.75})
    addBox(mesh, at, {-0.4, -share * width - 1.8, 5.4}, {-0.3, -share * width + 1.8, 7.4},
           Material::kSignFace);
}

}  // namespace

void addMotorway(Site& site) {
  addGuardRails(site);
  TriangleMesh& mesh = site.mesh();
  const double width = 2.0 * site.roads().front().half_width;
  Random random(hashOf(site.layout().seed, 980));
  alongRoadsides(site, random, 20.0, 1.5, [&](const Placement& at) {
    const double kind = random.uniform(0.0, 1.0);
    const Plot plot{at.moved(0.0, 2.5, 0.0), 0.5, 2.5};
    if (isBare(site, at.origin.head<2>()) || !site.isFree(plot, 0.5)) return;
    site.occupy(plot);
    if (kind < 0.06) return addGantry(mesh, at, width + 3.0);
    if (kind < 0.25) return addBoard(mesh, at.moved(0.0, 2.5, 0.0), random.uniform(1.0, 2.2));
    if (kind < 0.5) return addBush(mesh, at.at(0.0, 2.5, 0.0), random.uniform(0.8, 2.2), random);
    addBox(mesh, at, {-0.06, -0.06, -0.3}, {0.06, 0.06, 1.05}, Material::kPaint);
  });
  alongRoadsides(site, random, 11.0, 9.0, [&](const Placement& at) {
    const double nearest = isBare(site, at.origin.head<2>()) ? kBareRadius - 9.0 : 0.0;
    const Placement place = at.moved(0.0, nearest + random.uniform(0.0, 40.0), 0.0);
    if (!site.isFree({place, 1.0, 1.0}, 5.0)) return;
    site.occupy({place, 1.0, 1.0});
    const Eigen::Vector2d p = place.origin.head<2>();
    const Eigen::Vector3d root(p.x(), p.y(), site.ground(p) - 0.1);
    if (random.chance(0.5)) return addTree(mesh, root, random.uniform(4.0, 10.0), random);
    addBush(mesh, root, random.uniform(0.8, 2.5), random);
  });
}

}  // namespace revisit_slam::simulation
