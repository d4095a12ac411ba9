// SPDX-License-Identifier: MIT
#include "ground.h"
#include "roadside.h"
#include "structures.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kHeight = 2.8;

}  // namespace

void addCorridor(Site& site) {
  addEdging(site, {kHeight, 0.15, Material::kPlaster});
  const Eigen::Vector2d low = site.neighbourhood().low(), high = site.neighbourhood().high();
  addBox(site.mesh(), {}, {low.x(), low.y(), kHeight}, {high.x(), high.y(), kHeight + 0.2},
         Material::kPlaster);
  Random random(hashOf(site.layout().seed, 970));
  alongRoadsides(site, random, 9.0, 0.0, [&](const Placement& at) {
    if (site.fromRoad(at.flat(0.0, 0.05)) < 0.0) return;
    if (random.chance(0.6)) {
      addBox(site.mesh(), at, {-0.5, -0.06, 0.0}, {0.5, 0.05, 2.05}, Material::kPaint);
    } else {
      addBox(site.mesh(), at, {-0.25, -0.3, 0.0}, {0.25, 0.05, random.uniform(0.8, 2.8)},
             Material::kConcrete);
    }
  });
}

}  // namespace revisit_slam::simulation
