// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/loops/acceptance/pairwise_consistency.h"
#include "revisit_slam/loops/association/submap_association.h"
#include "revisit_slam/loops/registration/fine_registration_config.h"

namespace revisit_slam {

/// From a pair of local maps to constraints between their submaps (paper Sec. III-C).
struct LoopCloserConfig {
  AssociationConfig association;
  FineRegistrationConfig registration;
  std::string acceptance = "consistent";
  double min_fitness = 0.25;
  double min_coherence = 0.5;
  double max_translation = 6.0;
  double max_rotation = 15.0;
  double max_ambiguity = 0.95;
  DriftConfig drift;
  PairwiseConsistencyConfig consistency;

  // Stricter limits for a lone registration, which no other one between its local maps confirms.
  /// Share of max_rotation: repeated structure fits at large rotations, too.
  double lone_rotation_share = 1.0 / 3.0;
  /// Where between min_coherence (0) and 1 the limit of a retroactive one lies.
  double lone_coherence_share = 0.5;

  /// For surroundings that are narrower by this factor.
  LoopCloserConfig scaled(double scale) const {
    LoopCloserConfig config = *this;
    config.registration = registration.scaled(scale);
    config.max_translation *= scale;
    return config;
  }

  double loneCoherence() const {
    return (1.0 - lone_coherence_share) * min_coherence + lone_coherence_share;
  }

  template <typename Visitor>
  void visit(Visitor& v) {
    v.group("association", association);
    v.group("registration", registration);
    v("acceptance", acceptance, Choices{"consistent", "fitness"}, "",
      "what a registered pair of submaps has to pass. consistent: all gates below; fitness: "
      "correspondences and min_fitness alone, as in the paper");
    v("min_fitness", min_fitness, Range{0.0, 1.0}, "",
      "tau_f, smallest share of voxels with a counterpart in the other submap. Raise it if wrong "
      "loops are accepted; lower it if right loops of submaps that overlap little are rejected");
    v("min_coherence", min_coherence, Range{0.0, 1.0}, "",
      "smallest share of surfaces that coincide, among those with a surface of the other submap "
      "nearby; (1 + this) / 2 for a retroactive registration that no other confirms; 0: neither is "
      "checked. Raise it if registrations slide along repeated structure; "
      "lower it if scenes that changed between the visits are rejected");
    v("max_translation", max_translation, Range{0.0, 1000.0}, "m",
      "largest translation in metres of a registration from its first guess; also the distance "
      "within which rival poses are looked for. Raise it if drift is larger than this before a "
      "loop is closed; lower it if registrations reach a wrong minimum");
    v("max_rotation", max_rotation, Range{0.0, 180.0}, "deg",
      "largest rotation in degrees of a registration from its first guess; a third of it where no "
      "other registration of the same local maps confirms it. Raise it if drift is larger than "
      "this before a loop is closed; lower it if registrations reach a wrong minimum");
    v("max_ambiguity", max_ambiguity, Range{0.0, 10.0}, "",
      "largest ratio of what two submaps have in common at a rival pose, within the drift of the "
      "odometry and max_translation, to what they have in common at the registered one; above it "
      "the loop is rejected as ambiguous. Raise it if right loops along repeated structure are "
      "rejected; lower it if registrations are off by a period of the structure");
    v.group("drift", drift);
    v.group("consistency", consistency);
  }
};

}  // namespace revisit_slam
