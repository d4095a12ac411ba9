// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/acceptance_policy.h"

#include <algorithm>

#include "revisit_slam/loops/acceptance/registration_gates.h"

namespace revisit_slam {
namespace {

/// What is asked of every registration.
AcceptancePolicy commonGates(const LoopCloserConfig& config) {
  AcceptancePolicy policy{correspondencesGate(config.registration.min_correspondences),
                          convergenceGate(),
                          fitnessGate(config.min_fitness),
                          coherenceGate(config.min_coherence),
                          translationGate(config.max_translation),
                          rotationGate(config.max_rotation)};
  if (config.drift.max_deviation > 0.0) policy.push_back(driftGate(config.drift));
  policy.push_back(ambiguityGate(config.max_ambiguity, config.max_translation));
  return policy;
}

/// What the paper asks for (Sec. III-C), of a registration that has a result.
AcceptancePolicy fitnessPolicy(const LoopCloserConfig& config) {
  return {correspondencesGate(config.registration.min_correspondences),
          fitnessGate(config.min_fitness)};
}

/// The place was recognised: its appearance speaks for the loop, whatever the other pairs do. The
/// submaps are where the odometry placed them.
AcceptancePolicy appearancePolicy(const LoopCloserConfig& config) {
  AcceptancePolicy policy = commonGates(config);
  policy.push_back(onlyLone(rotationGate(config.lone_rotation_share * config.max_rotation)));
  policy.push_back(consistencyGate(config.consistency, {}));
  return policy;
}

/// Found by place alone. The graph has taken the drift out of where it placed the submaps:
/// registrations that start from there may not differ by it once more, and a lone one may not move.
AcceptancePolicy retroactivePolicy(const LoopCloserConfig& config) {
  AcceptancePolicy policy = commonGates(config);
  if (config.min_coherence > 0.0) policy.push_back(onlyLone(coherenceGate(config.loneCoherence())));
  policy.push_back(onlyLone(translationGate(config.consistency.translation)));
  policy.push_back(onlyLone(rotationGate(config.lone_rotation_share * config.max_rotation)));
  policy.push_back(consistencyGate(config.consistency.withoutDrift(), {kCoherenceGate}));
  return policy;
}

}  // namespace

AcceptancePolicy acceptancePolicy(LoopOrigin origin, const LoopCloserConfig& config) {
  if (config.acceptance == "fitness") return fitnessPolicy(config);
  return origin == LoopOrigin::appearance ? appearancePolicy(config) : retroactivePolicy(config);
}

std::vector<std::string> gateNames() {
  std::vector<std::string> names;
  for (const LoopOrigin origin : {LoopOrigin::retroactive, LoopOrigin::appearance})
    for (const Gate& gate : acceptancePolicy(origin, {}))
      if (std::find(names.begin(), names.end(), gate.name) == names.end())
        names.push_back(gate.name);
  return names;
}

}  // namespace revisit_slam
