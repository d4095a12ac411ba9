// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "revisit_slam/simulation/mesh.h"

namespace revisit_slam::simulation {

/// An upright frame in the map: x, y turned by yaw about z.
struct Placement {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double yaw = 0.0;

  Eigen::Vector3d at(double x, double y, double z) const;
  Eigen::Vector2d flat(double x, double y) const { return at(x, y, 0.0).head<2>(); }
  /// A frame at a place in this one.
  Placement moved(double x, double y, double z, double turn = 0.0) const;
};

void addTriangle(TriangleMesh& mesh, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                 const Eigen::Vector3d& c, Material material);

/// Corners in order around the quadrilateral.
void addQuad(TriangleMesh& mesh, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
             const Eigen::Vector3d& c, const Eigen::Vector3d& d, Material material);

/// An axis-aligned box of the placement.
void addBox(TriangleMesh& mesh, const Placement& at, const Eigen::Vector3d& low,
            const Eigen::Vector3d& high, Material material);

/// A cylinder or cone without end caps but the upper.
void addCylinder(TriangleMesh& mesh, const Eigen::Vector3d& base, const Eigen::Vector3d& top,
                 double base_radius, double top_radius, int sides, Material material);

}  // namespace revisit_slam::simulation
