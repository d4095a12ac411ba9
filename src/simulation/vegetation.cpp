// SPDX-License-Identifier: MIT
#include "vegetation.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam::simulation {
namespace {

constexpr double kTwoPi = 6.283185307179586;

Eigen::Vector3d anyDirection(Random& random) {
  const double z = random.uniform(-1.0, 1.0), angle = random.uniform(0.0, kTwoPi);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Leaves as triangles of all orientations inside an ellipsoid, denser near its surface.
void addCluster(TriangleMesh& mesh, const Eigen::Vector3d& centre, const Eigen::Vector3d& radii,
                int leaves, Random& random) {
  for (int k = 0; k < leaves; ++k) {
    const double depth = std::cbrt(random.uniform(0.15, 1.0));
    const Eigen::Vector3d p = centre + depth * anyDirection(random).cwiseProduct(radii);
    const double size = random.uniform(0.12, 0.3);
    addTriangle(mesh, p + size * anyDirection(random), p + size * anyDirection(random),
                p + size * anyDirection(random), Material::kFoliage);
  }
}

void addLimb(TriangleMesh& mesh, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
             double radius) {
  addCylinder(mesh, from, to, radius, 0.4 * radius, 5, Material::kBark);
}

void plant(Site& site, const Eigen::Vector2d& p, double spread, double clearance, Random& random) {
  const Plot plot{{{p.x(), p.y(), 0.0}, 0.0}, spread, spread};
  if (!site.isFree(plot, clearance)) return;
  site.occupy(plot);
  addTree(site.mesh(), {p.x(), p.y(), site.ground(p) - 0.1}, random.uniform(5.0, 15.0), random);
}

}  // namespace

void addTree(TriangleMesh& mesh, const Eigen::Vector3d& root, double height, Random& random) {
  const double radius = 0.012 * height + random.uniform(0.05, 0.15);
  const double clear = std::max(1.9, height * random.uniform(0.22, 0.4));
  const Eigen::Vector3d fork =
      root + Eigen::Vector3d(random.uniform(-0.25, 0.25), random.uniform(-0.25, 0.25), clear);
  const Eigen::Vector3d top =
      fork + Eigen::Vector3d(random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6),
                             0.55 * (height - clear));
  addCylinder(mesh, root, fork, 1.25 * radius, radius, 7, Material::kBark);
  addLimb(mesh, fork, top, radius);
  const double spread = height * random.uniform(0.16, 0.28);
  const int clusters = random.integer(4, 8);
  for (int k = 0; k < clusters; ++k) {
    const double angle = random.uniform(0.0, kTwoPi), reach = spread * random.uniform(0.2, 1.0);
    const Eigen::Vector3d centre(root.x() + reach * std::cos(angle),
                                 root.y() + reach * std::sin(angle),
                                 root.z() + clear + (height - clear) * random.uniform(0.15, 0.85));
    const double size = spread * random.uniform(0.4, 0.75);
    addLimb(mesh, fork, centre, 0.5 * radius);
    addCluster(mesh, centre,
               {size, size * random.uniform(0.7, 1.2), size * random.uniform(0.6, 0.95)},
               static_cast<int>(22.0 * size * size) + 14, random);
  }
}

void addBush(TriangleMesh& mesh, const Eigen::Vector3d& root, double size, Random& random) {
  addCluster(mesh, root + Eigen::Vector3d(0.0, 0.0, 0.5 * size),
             {size * random.uniform(0.6, 1.1), size * random.uniform(0.6, 1.1), 0.7 * size},
             static_cast<int>(60.0 * size) + 15, random);
}

void addStreetTrees(Site& site, double spacing) {
  Random random(hashOf(site.layout().seed, 940));
  for (const Road& road : site.roads()) {
    const Polyline line = resampled(road.middle, 1.0);
    for (const double side : {-1.0, 1.0}) {
      if (random.chance(0.3)) continue;
      double arc = random.uniform(0.0, spacing);
      for (; arc < static_cast<double>(line.size()); arc += spacing * random.uniform(0.6, 1.4)) {
        const auto k = static_cast<std::size_t>(arc);
        const Eigen::Vector2d along = directionAt(line, k);
        const double offset = side * (road.half_width + random.uniform(1.2, 1.7));
        plant(site, line[k].head<2>() + offset * Eigen::Vector2d(-along.y(), along.x()), 0.3, 0.7,
              random);
      }
    }
  }
}

void addScatteredTrees(Site& site, double density, double clearance) {
  Random random(hashOf(site.layout().seed, 941));
  const Neighbourhood& near = site.neighbourhood();
  const Eigen::Vector2d size = near.high() - near.low();
  const int tries = static_cast<int>(size.prod() * density / 1000.0);
  for (int k = 0; k < tries; ++k) {
    const Eigen::Vector2d p =
        near.low() + Eigen::Vector2d(random.uniform(0.0, size.x()), random.uniform(0.0, size.y()));
    if (random.chance(0.5)) {
      plant(site, p, random.uniform(0.8, 2.0), clearance, random);
      continue;
    }
    const double extent = random.uniform(0.4, 1.5);
    if (!site.isFree({{{p.x(), p.y(), 0.0}, 0.0}, extent, extent}, clearance)) continue;
    addBush(site.mesh(), {p.x(), p.y(), site.ground(p)}, extent, random);
  }
}

}  // namespace revisit_slam::simulation
