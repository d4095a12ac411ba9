// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/simulation/random.h"
#include "site.h"

namespace revisit_slam::simulation {

/// A trunk with limbs and a crown of scattered leaf clusters.
void addTree(TriangleMesh& mesh, const Eigen::Vector3d& root, double height, Random& random);
/// An uneven ball of leaves that stands on the ground.
void addBush(TriangleMesh& mesh, const Eigen::Vector3d& root, double size, Random& random);

/// Trees along the roads, one on average every `spacing` metres on each side.
void addStreetTrees(Site& site, double spacing);
/// Trees and bushes on open land, `density` for each 1000 square metres.
void addScatteredTrees(Site& site, double density, double clearance);

}  // namespace revisit_slam::simulation
