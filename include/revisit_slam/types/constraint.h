// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// An edge of the pose graph: where scan `to` is, seen from scan `from`. The residual is
/// Log(T_from_to^-1 * T_map_from^-1 * T_map_to); `information` weighs it, in the tangent space of
/// right perturbations of T_map_to, [translation; rotation].
struct Constraint {
  ScanId from, to;
  Pose T_from_to;
  Matrix6 information = Matrix6::Identity();
};

enum class LoopOrigin { appearance, retroactive };

/// A constraint between the keyposes (first scans) of two submaps: `from` is that of the target
/// submap r, `to` that of the source submap k, T_from_to is T_r_k (paper Sec. III-C).
struct LoopConstraint {
  Constraint constraint;
  SubmapId target, source;
  LocalMapId target_map, source_map;
  LoopOrigin origin = LoopOrigin::appearance;
  double fitness = 0.0;  ///< s_rk, the smaller of both directions, 0 … 1
  int inliers = 0;       ///< features that agreed on the local-map closure; 0 if retroactive
};

}  // namespace revisit_slam
