// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "revisit_slam/loops/acceptance/gate.h"
#include "revisit_slam/loops/acceptance/loop_closer_config.h"
#include "revisit_slam/loops/registration/fine_registration.h"
#include "revisit_slam/loops/registration/fine_registration_information.h"
#include "revisit_slam/types/constraint.h"
#include "revisit_slam/types/loop_candidate.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// A pair of submaps that was registered, and the verdict of the gates on it.
struct LoopProposal {
  LoopConstraint loop;  ///< the identity as information unless accepted
  LoopVerdict verdict;
  double hausdorff = 0.0;  ///< m, before the registration
  double overlap = 0.0;    ///< of what both see, before the registration
  RegisteredPair registered;
  double mean_squared_residual = 0.0;  ///< m^2, of the objective of the information
};

LoopCandidate candidateOf(const LoopProposal& proposal);

/// The constraints of those that were accepted.
std::vector<LoopConstraint> acceptedOf(const std::vector<LoopProposal>& proposals);

/// What is known of where the source lies in the target before they are registered.
using PriorOf = std::function<LoopPrior(const Submap& source, const Submap& target)>;

/// Closes loops between local maps: associates their submaps, registers each pair, and keeps those
/// that pass the gates of their origin (acceptance_policy.h). Runs in the current TBB arena; the
/// same bits for any number of threads.
class LoopCloser {
 public:
  LoopCloser(const LoopCloserConfig& config, const InformationConfig& information);

  /// Takes over the limits of the gates; how submaps are registered stays.
  void reconfigure(const LoopCloserConfig& config) { config_ = config; }

  const AssociationConfig& association() const { return config_.association; }

  /// From a guess of where the source is in the target (place recognition); submaps are placed in
  /// their local maps by the odometry.
  std::vector<LoopProposal> close(const LocalMap& source, const LocalMap& target,
                                  const Pose& T_target_source, LoopOrigin origin,
                                  const PriorOf& priorOf = {}) const;

  /// From submaps that are placed already, in the map (retroactive).
  std::vector<LoopProposal> close(const std::vector<PlacedSubmap>& sources,
                                  const std::vector<PlacedSubmap>& targets, LoopOrigin origin,
                                  const PriorOf& priorOf = {}) const;

 private:
  LoopCloserConfig config_;
  LoopInformation information_;
};

}  // namespace revisit_slam
