// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/loop_closer.h"

#include <algorithm>
#include <map>

namespace revisit_slam {
namespace {

constexpr double kDegrees = 180.0 / M_PI;
/// A pair that no other pair confirms may turn from its guess by this part of the limit only.
constexpr double kUnconfirmedRotation = 1.0 / 3.0;

/// The graph has taken the drift out of where it placed submaps: registrations that start from
/// there may not differ by it once more.
PairwiseConsistencyConfig consistencyFor(LoopOrigin origin, PairwiseConsistencyConfig config) {
  if (origin == LoopOrigin::retroactive) config.translation_drift = config.rotation_drift = 0.0;
  return config;
}

/// Where no other registration confirms it: turned far, or moved from where the graph has it.
bool isFarForOneAlone(const LoopProposal& proposal, const LoopCloserConfig& config) {
  if (proposal.moved_rotation > kUnconfirmedRotation * config.max_rotation) return true;
  return proposal.loop.origin == LoopOrigin::retroactive &&
         proposal.moved_translation > config.consistency.translation;
}

/// Found by place alone, and no other registration confirms it: then it has to be halfway between
/// barely coherent and perfectly so.
bool isIncoherentForOneAlone(const LoopProposal& proposal, const LoopCloserConfig& config) {
  return proposal.loop.origin == LoopOrigin::retroactive && config.min_coherence > 0.0 &&
         proposal.registration.coherence < 0.5 * (config.min_coherence + 1.0);
}

/// Submaps made ready for registration, each once, for the pairs of one closure.
class PreparedClouds {
 public:
  PreparedClouds(const std::vector<PlacedSubmap>& submaps, const FineRegistrationConfig& config)
      : submaps_(submaps), config_(config) {}

  const RegistrationCloud& operator[](std::size_t index) {
    return clouds_.try_emplace(index, *submaps_[index].submap, config_).first->second;
  }

 private:
  const std::vector<PlacedSubmap>& submaps_;
  const FineRegistrationConfig& config_;
  std::map<std::size_t, RegistrationCloud> clouds_;
};

LoopConstraint constraintOf(const Submap& source, const Submap& target,
                            const FineRegistrationResult& registration, LoopOrigin origin) {
  LoopConstraint loop;
  loop.constraint = {target.first_scan, source.first_scan, registration.T_target_source,
                     Matrix6::Identity()};
  loop.target = target.id;
  loop.source = source.id;
  loop.target_map = target.local_map;
  loop.source_map = source.local_map;
  loop.origin = origin;
  loop.fitness = registration.fitness;
  return loop;
}

}  // namespace

const char* toString(LoopOutcome outcome) {
  switch (outcome) {
    case LoopOutcome::accepted:
      return "accepted";
    case LoopOutcome::too_few_correspondences:
      return "too few correspondences";
    case LoopOutcome::not_converged:
      return "not converged";
    case LoopOutcome::low_fitness:
      return "low fitness";
    case LoopOutcome::incoherent:
      return "incoherent";
    case LoopOutcome::far_from_guess:
      return "far from the guess";
    case LoopOutcome::inconsistent:
      return "inconsistent";
  }
  return "unknown";
}

std::vector<LoopConstraint> acceptedOf(const std::vector<LoopProposal>& proposals) {
  std::vector<LoopConstraint> accepted;
  for (const LoopProposal& proposal : proposals)
    if (proposal.outcome == LoopOutcome::accepted) accepted.push_back(proposal.loop);
  return accepted;
}

LoopCloser::LoopCloser(const LoopCloserConfig& config, const InformationConfig& information)
    : config_(config),
      registration_(config.registration),
      information_(information, config.registration) {}

std::vector<LoopProposal> LoopCloser::close(const LocalMap& source, const LocalMap& target,
                                            const Pose& T_target_source, LoopOrigin origin) const {
  return close(placeByOdometry(source, T_target_source), placeByOdometry(target, Pose::identity()),
               origin);
}

std::vector<LoopProposal> LoopCloser::close(const std::vector<PlacedSubmap>& sources,
                                            const std::vector<PlacedSubmap>& targets,
                                            LoopOrigin origin) const {
  const std::vector<SubmapPair> pairs = associate(sources, targets, config_.association);
  std::vector<LoopProposal> proposals = registerPairs(pairs, sources, targets, origin);
  dropContradictions(pairs, sources, targets, proposals);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (proposals[i].outcome == LoopOutcome::accepted) {
      Constraint& constraint = proposals[i].loop.constraint;
      constraint.information = information_.estimate(
          *sources[pairs[i].source].submap, *targets[pairs[i].target].submap, constraint.T_from_to);
    }
  return proposals;
}

std::vector<LoopProposal> LoopCloser::registerPairs(const std::vector<SubmapPair>& pairs,
                                                    const std::vector<PlacedSubmap>& sources,
                                                    const std::vector<PlacedSubmap>& targets,
                                                    LoopOrigin origin) const {
  PreparedClouds source_clouds(sources, config_.registration);
  PreparedClouds target_clouds(targets, config_.registration);
  std::vector<LoopProposal> proposals;
  for (const SubmapPair& pair : pairs) {
    const PlacedSubmap &source = sources[pair.source], &target = targets[pair.target];
    const Pose guess = target.T_common_submap.inverse() * source.T_common_submap;
    LoopProposal proposal;
    proposal.registration =
        registration_.align(source_clouds[pair.source], target_clouds[pair.target], guess);
    const Pose moved = guess.inverse() * proposal.registration.T_target_source;
    proposal.moved_translation = moved.translation.norm();
    proposal.moved_rotation = moved.angle() * kDegrees;
    proposal.hausdorff = pair.hausdorff;
    proposal.loop = constraintOf(*source.submap, *target.submap, proposal.registration, origin);
    proposal.outcome = judge(proposal);
    proposals.push_back(proposal);
  }
  return proposals;
}

LoopOutcome LoopCloser::judge(const LoopProposal& proposal) const {
  const FineRegistrationResult& registration = proposal.registration;
  if (registration.outcome == FineRegistrationOutcome::too_few_correspondences)
    return LoopOutcome::too_few_correspondences;
  if (registration.outcome == FineRegistrationOutcome::max_iterations)
    return LoopOutcome::not_converged;
  if (registration.fitness <= config_.min_fitness) return LoopOutcome::low_fitness;
  if (registration.coherence < config_.min_coherence) return LoopOutcome::incoherent;
  if (proposal.moved_translation > config_.max_translation ||
      proposal.moved_rotation > config_.max_rotation)
    return LoopOutcome::far_from_guess;
  return LoopOutcome::accepted;
}

void LoopCloser::dropContradictions(const std::vector<SubmapPair>& pairs,
                                    const std::vector<PlacedSubmap>& sources,
                                    const std::vector<PlacedSubmap>& targets,
                                    std::vector<LoopProposal>& proposals) const {
  std::vector<std::size_t> candidates;
  std::vector<RegisteredPair> registered;
  std::size_t incoherent = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (proposals[i].outcome == LoopOutcome::incoherent) ++incoherent;
    if (proposals[i].outcome != LoopOutcome::accepted) continue;
    candidates.push_back(i);
    registered.push_back(
        {targets[pairs[i].target].T_common_submap, sources[pairs[i].source].T_common_submap,
         proposals[i].registration.T_target_source, proposals[i].registration.fitness});
  }
  if (candidates.empty()) return;
  LoopProposal& first = proposals[candidates[0]];
  if (candidates.size() == 1) {
    if (isFarForOneAlone(first, config_)) first.outcome = LoopOutcome::far_from_guess;
    if (isIncoherentForOneAlone(first, config_)) first.outcome = LoopOutcome::incoherent;
    if (first.outcome != LoopOutcome::accepted) return;
  }
  const LoopOrigin origin = first.loop.origin;
  // For a place that was recognised its appearance speaks too, whatever the other walls do.
  const std::size_t others = origin == LoopOrigin::retroactive ? incoherent : 0;
  const std::vector<bool> belongs =
      majority(registered, others, consistencyFor(origin, config_.consistency));
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (!belongs[i]) proposals[candidates[i]].outcome = LoopOutcome::inconsistent;
}

}  // namespace revisit_slam
