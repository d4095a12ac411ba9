// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/constraint.h"
#include "revisit_slam/types/ids.h"

namespace revisit_slam {

/// Whether a loop constraint takes part in the optimisation.
enum class LoopState {
  active,
  rejected,  ///< by the graph: it would override established loops; tried again later
  disabled,  ///< left out on request
};

const char* toString(LoopState state);
const char* toString(LoopOrigin origin);

/// A loop constraint in the graph and what the optimisation made of it; chi2 = e^T information e.
struct LoopEdge {
  LoopId id;
  LoopConstraint loop;
  LoopState state = LoopState::active;
  double chi2_before = 0.0;  ///< before the optimisation that tried it last
  double chi2_after = 0.0;   ///< after the last optimisation
  double weight = 0.0;       ///< of the robust kernel, 0 … 1; near 0: without effect
};

}  // namespace revisit_slam
