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

std::vector<LoopConstraint> acceptedOf(const std::vector<LoopProposal>& proposals) {
  std::vector<LoopConstraint> accepted;
  for (const LoopProposal& proposal : proposals)
    if (proposal.verdict.isAccepted()) accepted.push_back(proposal.loop);
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
  const std::vector<RegisteredPair> registered = registerPairs(pairs, sources, targets);
  const std::vector<LoopVerdict> verdicts = judge(registered, acceptancePolicy(origin, config_));
  std::vector<LoopProposal> proposals;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Submap &source = *sources[pairs[i].source].submap,
                 &target = *targets[pairs[i].target].submap;
    LoopProposal proposal{constraintOf(source, target, registered[i].registration, origin),
                          verdicts[i], pairs[i].hausdorff, registered[i]};
    Constraint& constraint = proposal.loop.constraint;
    if (proposal.verdict.isAccepted())
      constraint.information = information_.estimate(source, target, constraint.T_from_to);
    proposals.push_back(std::move(proposal));
  }
  return proposals;
}

std::vector<RegisteredPair> LoopCloser::registerPairs(
    const std::vector<SubmapPair>& pairs, const std::vector<PlacedSubmap>& sources,
    const std::vector<PlacedSubmap>& targets) const {
  PreparedClouds source_clouds(sources, config_.registration);
  PreparedClouds target_clouds(targets, config_.registration);
  std::vector<RegisteredPair> registered;
  for (const SubmapPair& pair : pairs) {
    const Pose &T_common_target = targets[pair.target].T_common_submap,
               &T_common_source = sources[pair.source].T_common_submap;
    const Pose guess = T_common_target.inverse() * T_common_source;
    registered.push_back(
        {T_common_target, T_common_source,
         registration_.align(source_clouds[pair.source], target_clouds[pair.target], guess)});
  }
  return registered;
}

}  // namespace revisit_slam
