// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/cost_function.h>

#include <memory>

#include "revisit_slam/pose_graph/factor.h"

namespace revisit_slam {

/// The Ceres term U e of a factor, with U^T U = information, over one pose block (pose_block.h) for
/// each of its nodes. The factor must outlive it. Its Jacobians by right perturbations are turned
/// into derivatives by the seven block entries with those of the manifold's Minus.
std::unique_ptr<ceres::CostFunction> makeCost(const Factor& factor);

}  // namespace revisit_slam
