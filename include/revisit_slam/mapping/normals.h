// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/mapping/voxel_mean_grid.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Unit normals of a grid's voxel means, by principal components over the means in the 27 voxels
/// around each; zero where those are few, or do not spread over a plane (edges, poles, foliage).
/// The sign is that of a normal that points to the origin of the grid. Runs in the current TBB
/// arena.
Points estimateNormals(const VoxelMeans& means);

}  // namespace revisit_slam
