// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/pose_graph/factor.h"

namespace revisit_slam {

/// The relative pose that a factor measures if the factor is plain odometry: from a node to the
/// next, without a robust kernel. Null for all others.
const RelativePoseFactor* chainLink(const Factor& factor);

/// Links Z_1 … Z_K, each starting where the one before ends.
using ChainPiece = std::vector<const RelativePoseFactor*>;

/// The factor from the first to the last node of the piece that says the same about these two
/// as all of the piece's together, for small errors. With errors n_k in Z_k Exp(n_k), the last node
/// moves by d_K,
///
///   d_k = Ad(Z_k^-1) d_{k-1} + n_k,  S_k = Ad(Z_k^-1) S_{k-1} Ad(Z_k^-1)^T + information_k^-1.
RelativePoseFactor composed(const ChainPiece& piece);

/// Poses of the inner nodes 1 … K-1, given those of both ends: with D_k = Z_1 … Z_k, of the
/// deviation d_K = Log(D_K^-1 T_map_first^-1 T_map_last) node k takes its most likely share,
///
///   d_k = S_k Ad(D_K^-1 D_k)^T S_K^-1 d_K,  T_map_k = T_map_first D_k Exp(d_k).
std::vector<Pose> bentPiece(const ChainPiece& piece, const Pose& T_map_first,
                            const Pose& T_map_last);

}  // namespace revisit_slam
