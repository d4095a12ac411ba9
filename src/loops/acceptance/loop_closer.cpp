// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/loop_closer.h"

#include <map>
#include <utility>

#include "revisit_slam/loops/acceptance/acceptance_policy.h"

namespace revisit_slam {
namespace {

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

std::vector<RegisteredPair> registerPairs(const std::vector<SubmapPair>& pairs,
                                          const std::vector<PlacedSubmap>& sources,
                                          const std::vector<PlacedSubmap>& targets,
                                          const FineRegistrationConfig& config) {
  const FineRegistration registration(config);
  PreparedClouds source_clouds(sources, config), target_clouds(targets, config);
  std::vector<RegisteredPair> registered;
  for (const SubmapPair& pair : pairs) {
    const PlacedSubmap &target = targets[pair.target], &source = sources[pair.source];
    const Pose guess = target.T_common_submap.inverse() * source.T_common_submap;
    registered.push_back(
        {target.T_common_submap, source.T_common_submap,
         registration.align(source_clouds[pair.source], target_clouds[pair.target], guess),
         LoopPrior{}, target.submap, source.submap});
  }
  return registered;
}

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

LoopCandidate candidateOf(const LoopProposal& proposal) {
  const LoopConstraint& loop = proposal.loop;
  const GateMeasurement& gate = proposal.verdict.measurement;
  return {loop.origin, loop.target_map, loop.source_map,
          loop.target, loop.source,     proposal.verdict.outcome(),
          gate.value,  gate.limit,      gate.unit};
}

std::vector<LoopConstraint> acceptedOf(const std::vector<LoopProposal>& proposals) {
  std::vector<LoopConstraint> accepted;
  for (const LoopProposal& proposal : proposals)
    if (proposal.verdict.isAccepted()) accepted.push_back(proposal.loop);
  return accepted;
}

LoopCloser::LoopCloser(const LoopCloserConfig& config, const InformationConfig& information)
    : config_(config), information_(information, config.registration) {}

std::vector<LoopProposal> LoopCloser::close(const LocalMap& source, const LocalMap& target,
                                            const Pose& T_target_source, LoopOrigin origin,
                                            const PriorOf& priorOf) const {
  return close(placeByOdometry(source, T_target_source), placeByOdometry(target, Pose::identity()),
               origin, priorOf);
}

std::vector<LoopProposal> LoopCloser::close(const std::vector<PlacedSubmap>& sources,
                                            const std::vector<PlacedSubmap>& targets,
                                            LoopOrigin origin, const PriorOf& priorOf) const {
  const LoopCloserConfig config = config_.scaled(scaleOf(sources, targets));
  const std::vector<SubmapPair> pairs = associate(sources, targets, config.association);
  std::vector<RegisteredPair> registered =
      registerPairs(pairs, sources, targets, config.registration);
  if (priorOf)
    for (RegisteredPair& pair : registered) pair.prior = priorOf(*pair.source, *pair.target);
  const std::vector<LoopVerdict> verdicts = judge(registered, acceptancePolicy(origin, config));
  std::vector<LoopProposal> proposals;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Submap &source = *registered[i].source, &target = *registered[i].target;
    LoopProposal proposal{constraintOf(source, target, registered[i].registration, origin),
                          verdicts[i], pairs[i].hausdorff, pairs[i].overlap, registered[i]};
    if (proposal.verdict.isAccepted()) {
      Constraint& constraint = proposal.loop.constraint;
      const InformationEstimate estimate =
          information_.estimate(source, registered[i].target, constraint.T_from_to);
      constraint.information = estimate.information;
      proposal.mean_squared_residual = estimate.mean_squared_residual;
    }
    proposals.push_back(std::move(proposal));
  }
  return proposals;
}

}  // namespace revisit_slam
