// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace revisit_slam::simulation {

enum class Material : std::uint8_t {
  kAsphalt,
  kPavement,
  kGrass,
  kPlaster,
  kBrick,
  kGlass,
  kRoof,
  kFoliage,
  kBark,
  kMetal,
  kPaint,
  kSignFace,
  kConcrete,
  kCloth,
};

/// Fraction of the light that a surface sends back when met at a right angle.
double reflectivityOf(Material material);

/// Triangles in metres; vertices in the frame of what the mesh describes.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// One for each triangle.
  std::vector<Material> materials;
};

}  // namespace revisit_slam::simulation
