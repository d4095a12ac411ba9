// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/ids.h"

namespace revisit_slam {

/// Counts the nodes of one PoseGraph, from 0, without gaps. What a node stands for is the business
/// of whoever makes the graph.
using NodeId = Id<struct NodeTag>;
/// Counts the factors of one PoseGraph, from 0, without gaps.
using FactorId = Id<struct FactorTag>;

}  // namespace revisit_slam
