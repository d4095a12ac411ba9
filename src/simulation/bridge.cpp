// SPDX-License-Identifier: MIT
#include <cmath>

#include "revisit_slam/simulation/layout.h"
#include "structures.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kHalfDeck = 7.2;
constexpr int kLampSpacing = 28;
constexpr int kPierSpacing = 40;

/// One metre of the bridge; x runs along it from 0 to 1.
void addPiece(TriangleMesh& mesh, const Placement& at, double rise) {
  const auto corner = [&](double x, double y, double z) { return at.at(x, y, z + rise * x); };
  const double w = kHalfDeck;
  addQuad(mesh, corner(0, -w, 0), corner(1, -w, 0), corner(1, w, 0), corner(0, w, 0),
          Material::kAsphalt);
  addQuad(mesh, corner(0, -w, -0.8), corner(1, -w, -0.8), corner(1, w, -0.8), corner(0, w, -0.8),
          Material::kConcrete);
  for (const double side : {-1.0, 1.0}) {
    const double y = side * w, kerb = side * (w - 1.7);
    addQuad(mesh, corner(0, y, -0.8), corner(1, y, -0.8), corner(1, y, 0.25), corner(0, y, 0.25),
            Material::kConcrete);
    addQuad(mesh, corner(0, kerb, 0), corner(1, kerb, 0), corner(1, kerb, 0.15),
            corner(0, kerb, 0.15), Material::kConcrete);
    addQuad(mesh, corner(0, kerb, 0.15), corner(1, kerb, 0.15), corner(1, y, 0.15),
            corner(0, y, 0.15), Material::kPavement);
    for (const double z : {0.55, 0.8, 1.1}) {
      addCylinder(mesh, corner(0, y, z), corner(1, y, z), 0.04, 0.04, 4, Material::kMetal);
    }
  }
}

void addPosts(TriangleMesh& mesh, const Placement& at, int index) {
  for (const double side : {-1.0, 1.0}) {
    const double y = side * kHalfDeck;
    if (index % 2 == 0)
      addBox(mesh, at, {-0.05, y - 0.05, 0.0}, {0.05, y + 0.05, 1.15}, Material::kMetal);
    if (index % kLampSpacing == 0) {
      addCylinder(mesh, at.at(0, y, 0), at.at(0, y, 7.0), 0.11, 0.07, 8, Material::kMetal);
      addBox(mesh, at, {-0.12, y - side * 1.9, 7.0}, {0.12, y, 7.12}, Material::kMetal);
    }
    if (index % kPierSpacing == 0) {
      addBox(mesh, at, {-0.8, y - side * 2.5, -25.0}, {0.8, y - side * 1.0, -0.8},
             Material::kConcrete);
    }
  }
}

}  // namespace

void addBridge(Site& site) {
  const StreetGrid grid(site.layout());
  const Terrain& terrain = site.route().terrain();
  const Eigen::Vector2d from = grid.position({0, 0}), to = grid.position({1, 0});
  const Polyline line = resampled({{from.x(), from.y(), 0.0}, {to.x(), to.y(), 0.0}}, 1.0);
  const double yaw = std::atan2(to.y() - from.y(), to.x() - from.x());
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Eigen::Vector2d p = line[k].head<2>(), next = line[k + 1].head<2>();
    const double height = terrain.roadHeight(p.x(), p.y());
    if (height - terrain.height(p) < 0.02) continue;
    const Placement at{{p.x(), p.y(), height}, yaw};
    addPiece(site.mesh(), at, terrain.roadHeight(next.x(), next.y()) - height);
    addPosts(site.mesh(), at, static_cast<int>(k));
  }
}

}  // namespace revisit_slam::simulation
