// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/minimize.h"

namespace revisit_slam {

/// Minimises where factors have redescending kernels without trusting the start: drift makes right
/// loops start far away, where these have hardly any influence. First without these kernels, then
/// with them widened until they take in all such factors and narrowed step by step to their scales
/// (graduated non-convexity: Yang et al., RA-L 2020). The same is tried straight from the start;
/// the lower cost wins. Other graphs are minimised as they are.
Minimum graduatedMinimize(const PoseGraph& graph, const std::vector<Pose>& start,
                          const MinimizeLimits& limits);

/// Whether any factor has a redescending kernel.
bool hasRedescendingKernel(const PoseGraph& graph);

}  // namespace revisit_slam
