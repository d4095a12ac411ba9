// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/loops/acceptance/gate.h"

namespace revisit_slam {

// Gates that look at one registration by itself.

/// Points of the source with a counterpart when the registration ended.
inline Gate correspondencesGate(int min_correspondences) {
  return gateOfEach("correspondences", [min_correspondences](const RegisteredPair& pair) {
    return GateMeasurement{static_cast<double>(pair.registration.inliers), Bound::at_least,
                           static_cast<double>(min_correspondences), ""};
  });
}

/// 1 if the finest level settled, else 0.
inline Gate convergenceGate() {
  return gateOfEach("convergence", [](const RegisteredPair& pair) {
    const bool converged = pair.registration.outcome == FineRegistrationOutcome::converged;
    return GateMeasurement{converged ? 1.0 : 0.0, Bound::at_least, 1.0, ""};
  });
}

/// tau_f (paper Sec. III-C): the submaps overlap.
inline Gate fitnessGate(double min_fitness) {
  return gateOfEach("fitness", [min_fitness](const RegisteredPair& pair) {
    return GateMeasurement{pair.registration.fitness, Bound::above, min_fitness, ""};
  });
}

constexpr const char* kCoherenceGate = "coherence";

/// Where both submaps have surfaces, these are the same, not ones that stand beside each other.
inline Gate coherenceGate(double min_coherence) {
  return gateOfEach(kCoherenceGate, [min_coherence](const RegisteredPair& pair) {
    return GateMeasurement{pair.registration.coherence, Bound::at_least, min_coherence, ""};
  });
}

/// The registration stayed where the guess can be wrong, m.
inline Gate translationGate(double max_translation) {
  return gateOfEach("translation", [max_translation](const RegisteredPair& pair) {
    return GateMeasurement{pair.movedTranslation(), Bound::at_most, max_translation, "m"};
  });
}

/// The registration turned no farther than the guess can be wrong, degrees.
inline Gate rotationGate(double max_rotation) {
  return gateOfEach("rotation", [max_rotation](const RegisteredPair& pair) {
    return GateMeasurement{pair.movedRotation(), Bound::at_most, max_rotation, "deg"};
  });
}

/// The loop is where the graph expects it, within what the odometry drifts.
inline Gate driftGate(const DriftConfig& config) {
  return gateOfEach("drift", [config](const RegisteredPair& pair) {
    return GateMeasurement{pair.deviation(config), Bound::at_most, config.max_deviation, "sigma"};
  });
}

/// No other pose that the drift allows explains the submaps as well.
inline Gate ambiguityGate(double max_ambiguity, double max_translation) {
  return gateOfEach("ambiguity", [=](const RegisteredPair& pair) {
    return GateMeasurement{pair.ambiguity(max_translation), Bound::at_most, max_ambiguity, ""};
  });
}

}  // namespace revisit_slam
