// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/minimize.h"

namespace revisit_slam {

/// Minimises with a kernel that hardly feels far loops (RobustKernel::forgetsFarLoops) without
/// trusting the start: drift makes right loops start far away. First without kernel, then with the
/// kernel widened until it takes in all loops and narrowed step by step to its scale (graduated
/// non-convexity: Yang et al., RA-L 2020). The same is tried straight from the start; the lower
/// cost wins. Other kernels are minimised as they are.
Minimum graduatedMinimize(const PoseGraph& graph, const std::vector<Pose>& start,
                          const RobustKernel& kernel, const MinimizeLimits& limits);

}  // namespace revisit_slam
