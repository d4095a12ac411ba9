// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/icp/local_voxel_map.h"
#include "revisit_slam/information/perturbation_design.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// The map points that can become the nearest neighbour of a point under the perturbations of one
/// design, relative to the point, in the base frame. CSR: point i has [begin[i], begin[i + 1]).
struct Candidates {
  std::vector<std::uint32_t> begin{0};
  Points relative_base;
};

/// All that the objective chi(T * Exp(d)) = sum_i min(|T Exp(d) p_i - q_nn(i)|^2, tau^2) (paper
/// Eq. 1 with the kernel TruncatedQuadratic) depends on for the perturbations d of the designs: a
/// registration taken out of its map. The map may change afterwards.
struct RegistrationProblem {
  Points points_base;
  double tau = 0.0;    ///< m, truncation distance
  double scale = 1.0;  ///< registered points per point kept here
  /// For each chunk of kChunkLength points, for each design.
  std::vector<std::vector<Candidates>> chunks;

  static constexpr std::size_t kChunkLength = 128;
};

/// Gathers the candidates from the map that a scan was registered to. A map point is left out only
/// where no perturbation within the ranges of the design can make it the nearest one: the objective
/// comes out as with a search of the whole map, to the last bit. `tau` is cut to the edge of a
/// voxel, up to which the map knows the nearest neighbour. Runs in the current TBB arena.
RegistrationProblem gatherProblem(const Points& points_base, const LocalVoxelMap& map,
                                  const Pose& T_odom_base, double tau, std::size_t max_points,
                                  const std::vector<PerturbationDesign>& designs);

}  // namespace revisit_slam
