// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/loops/acceptance/loop_closer_config.h"
#include "revisit_slam/loops/registration/fine_registration.h"
#include "revisit_slam/loops/registration/fine_registration_information.h"
#include "revisit_slam/types/constraint.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

enum class LoopOutcome {
  accepted,
  too_few_correspondences,
  not_converged,
  low_fitness,     ///< the submaps overlap too little
  incoherent,      ///< surfaces stand beside each other
  far_from_guess,  ///< the registration went farther than the guess can be wrong
  inconsistent,    ///< contradicts the other pairs of these local maps, or no majority
};

const char* toString(LoopOutcome outcome);

/// A pair of submaps that was registered, and what became of it.
struct LoopProposal {
  LoopConstraint loop;  ///< the identity as information unless accepted
  LoopOutcome outcome = LoopOutcome::accepted;
  double hausdorff = 0.0;          ///< m, before the registration
  double moved_translation = 0.0;  ///< m, from the guess to the result
  double moved_rotation = 0.0;     ///< degrees
  FineRegistrationResult registration;
};

/// The constraints of those that were accepted.
std::vector<LoopConstraint> acceptedOf(const std::vector<LoopProposal>& proposals);

/// Closes loops between local maps: associates their submaps, registers each pair, and keeps what
/// fits and agrees. Runs in the current TBB arena; the same bits for any number of threads.
class LoopCloser {
 public:
  LoopCloser(const LoopCloserConfig& config, const InformationConfig& information);

  /// Takes over what judges a registration; how it is done stays.
  void reconfigure(const LoopCloserConfig& config) { config_ = config; }

  /// From a guess of where the source is in the target (place recognition); submaps are placed in
  /// their local maps by the odometry.
  std::vector<LoopProposal> close(const LocalMap& source, const LocalMap& target,
                                  const Pose& T_target_source, LoopOrigin origin) const;

  /// From submaps that are placed already, in the map (retroactive).
  std::vector<LoopProposal> close(const std::vector<PlacedSubmap>& sources,
                                  const std::vector<PlacedSubmap>& targets,
                                  LoopOrigin origin) const;

 private:
  LoopOutcome judge(const LoopProposal& proposal) const;
  std::vector<LoopProposal> registerPairs(const std::vector<SubmapPair>& pairs,
                                          const std::vector<PlacedSubmap>& sources,
                                          const std::vector<PlacedSubmap>& targets,
                                          LoopOrigin origin) const;
  void dropContradictions(const std::vector<SubmapPair>& pairs,
                          const std::vector<PlacedSubmap>& sources,
                          const std::vector<PlacedSubmap>& targets,
                          std::vector<LoopProposal>& proposals) const;

  LoopCloserConfig config_;
  FineRegistration registration_;
  LoopInformation information_;
};

}  // namespace revisit_slam
