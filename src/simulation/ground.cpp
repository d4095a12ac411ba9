// SPDX-License-Identifier: MIT
#include "ground.h"

#include <cmath>

namespace revisit_slam::simulation {
namespace {

constexpr double kTile = 16.0;
constexpr double kFine = 0.5;
constexpr double kCoarse = 2.0;
constexpr double kFineReach = 12.0;

Material surfaceAt(const Site& site, const Eigen::Vector2d& p) {
  const WorldKind kind = site.layout().kind;
  if (isPaved(kind)) return Material::kConcrete;
  const double outside = site.fromRoad(p);
  if (kind == WorldKind::kField) return Material::kGrass;
  if (outside < 0.0) return kind == WorldKind::kCampus ? Material::kPavement : Material::kAsphalt;
  return outside < 2.2 && kind != WorldKind::kCampus ? Material::kPavement : Material::kGrass;
}

void addTile(Site& site, const Eigen::Vector2d& corner, double cell) {
  const int count = static_cast<int>(std::lround(kTile / cell));
  const auto width = static_cast<std::uint32_t>(count + 1);
  TriangleMesh& mesh = site.mesh();
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int j = 0; j <= count; ++j) {
    for (int i = 0; i <= count; ++i) {
      const Eigen::Vector2d p = corner + cell * Eigen::Vector2d(i, j);
      mesh.vertices.push_back(Eigen::Vector3d(p.x(), p.y(), site.ground(p)).cast<float>());
    }
  }
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector2d p = corner + cell * Eigen::Vector2d(i + 0.5, j + 0.5);
      if (site.route().terrain().isWater(p.x(), p.y())) continue;
      const std::uint32_t a =
          first + static_cast<std::uint32_t>(j) * width + static_cast<std::uint32_t>(i);
      mesh.triangles.push_back({a, a + 1, a + width + 1});
      mesh.triangles.push_back({a, a + width + 1, a + width});
      mesh.materials.insert(mesh.materials.end(), 2, surfaceAt(site, p));
    }
  }
}

}  // namespace

void addGround(Site& site) {
  const Neighbourhood& near = site.neighbourhood();
  const Eigen::Vector2d half(0.5 * kTile, 0.5 * kTile);
  for (double x = std::floor(near.low().x() / kTile) * kTile; x < near.high().x(); x += kTile) {
    for (double y = std::floor(near.low().y() / kTile) * kTile; y < near.high().y(); y += kTile) {
      const Eigen::Vector2d corner(x, y);
      if (!near.contains(corner + half)) continue;
      const bool fine = site.fromRoute(corner + half) < kFineReach + 0.5 * kTile;
      addTile(site, corner, fine ? kFine : kCoarse);
    }
  }
}

void addEdging(Site& site, const Edging& edging) {
  for (const Road& road : site.roads()) {
    const Polyline line = resampled(road.middle, 1.0);
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const Eigen::Vector2d along = directionAt(line, k);
      for (const double side : {-1.0, 1.0}) {
        const double offset = road.half_width + 0.5 * edging.thickness;
        const Eigen::Vector2d p =
            line[k].head<2>() + side * offset * Eigen::Vector2d(-along.y(), along.x());
        if (site.fromRoad(p) < 0.02 || !site.isNear(p)) continue;
        const Terrain& terrain = site.route().terrain();
        if (terrain.roadHeight(p.x(), p.y()) > terrain.height(p) + 0.05) continue;
        const Placement at{{p.x(), p.y(), terrain.height(p)}, std::atan2(along.y(), along.x())};
        addBox(site.mesh(), at, {-0.52, -0.5 * edging.thickness, -0.2},
               {0.52, 0.5 * edging.thickness, edging.height}, edging.material);
      }
    }
  }
}

}  // namespace revisit_slam::simulation
