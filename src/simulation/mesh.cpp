// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/mesh.h"

namespace revisit_slam::simulation {

double reflectivityOf(Material material) {
  switch (material) {
    case Material::kAsphalt:
      return 0.14;
    case Material::kPavement:
      return 0.28;
    case Material::kGrass:
      return 0.35;
    case Material::kPlaster:
      return 0.55;
    case Material::kBrick:
      return 0.32;
    case Material::kGlass:
      return 0.03;
    case Material::kRoof:
      return 0.22;
    case Material::kFoliage:
      return 0.45;
    case Material::kBark:
      return 0.25;
    case Material::kMetal:
      return 0.4;
    case Material::kPaint:
      return 0.3;
    case Material::kSignFace:
      return 1.0;
    case Material::kConcrete:
      return 0.38;
    case Material::kCloth:
      return 0.4;
  }
  return 0.3;
}

}  // namespace revisit_slam::simulation
