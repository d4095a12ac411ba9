// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/loops/acceptance/gate.h"
#include "revisit_slam/loops/acceptance/loop_closer_config.h"
#include "revisit_slam/types/constraint.h"

namespace revisit_slam {

/// The gates that registrations of one origin have to pass, in order.
using AcceptancePolicy = std::vector<Gate>;

/// What is asked of loops of one origin: the only place that says which gates there are, in what
/// order, and with what limits. To add a gate:
///  1. write it in registration_gates.h, or in a header of its own if it looks at several pairs;
///  2. put its limit into LoopCloserConfig, if a user should set it;
///  3. add it to the lists in acceptance_policy.cpp.
/// The test of the lists and the table of gates in docs/loops.md follow.
/// Its name then stands in loops.json, the tables of benchmark_loops and rviz.
AcceptancePolicy acceptancePolicy(LoopOrigin origin, const LoopCloserConfig& config);

/// The names of all gates of all origins, in order.
std::vector<std::string> gateNames();

}  // namespace revisit_slam
