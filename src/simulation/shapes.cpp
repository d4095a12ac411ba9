// SPDX-License-Identifier: MIT
#include "shapes.h"

#include <Eigen/Geometry>
#include <cmath>

namespace revisit_slam::simulation {
namespace {

constexpr double kTwoPi = 6.283185307179586;

std::uint32_t addVertex(TriangleMesh& mesh, const Eigen::Vector3d& p) {
  mesh.vertices.push_back(p.cast<float>());
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

}  // namespace

Eigen::Vector3d Placement::at(double x, double y, double z) const {
  const double c = std::cos(yaw), s = std::sin(yaw);
  return origin + Eigen::Vector3d(c * x - s * y, s * x + c * y, z);
}

Placement Placement::moved(double x, double y, double z, double turn) const {
  return {at(x, y, z), yaw + turn};
}

void addTriangle(TriangleMesh& mesh, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                 const Eigen::Vector3d& c, Material material) {
  mesh.triangles.push_back({addVertex(mesh, a), addVertex(mesh, b), addVertex(mesh, c)});
  mesh.materials.push_back(material);
}

void addQuad(TriangleMesh& mesh, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
             const Eigen::Vector3d& c, const Eigen::Vector3d& d, Material material) {
  const std::uint32_t first = addVertex(mesh, a);
  addVertex(mesh, b);
  addVertex(mesh, c);
  addVertex(mesh, d);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
  mesh.materials.insert(mesh.materials.end(), 2, material);
}

void addBox(TriangleMesh& mesh, const Placement& at, const Eigen::Vector3d& low,
            const Eigen::Vector3d& high, Material material) {
  const auto corner = [&](int i) {
    return at.at((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                 (i & 4) != 0 ? high.z() : low.z());
  };
  constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  for (const auto& face : kFaces) {
    addQuad(mesh, corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3]), material);
  }
}

void addCylinder(TriangleMesh& mesh, const Eigen::Vector3d& base, const Eigen::Vector3d& top,
                 double base_radius, double top_radius, int sides, Material material) {
  const Eigen::Vector3d axis = (top - base).normalized();
  const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  const auto rim = [&](int k) -> Eigen::Vector3d {
    const double angle = kTwoPi * k / sides;
    return std::cos(angle) * u + std::sin(angle) * v;
  };
  for (int k = 0; k < sides; ++k) {
    const Eigen::Vector3d a = rim(k), b = rim(k + 1);
    addQuad(mesh, base + base_radius * a, base + base_radius * b, top + top_radius * b,
            top + top_radius * a, material);
    addTriangle(mesh, top, top + top_radius * a, top + top_radius * b, material);
  }
}

}  // namespace revisit_slam::simulation
