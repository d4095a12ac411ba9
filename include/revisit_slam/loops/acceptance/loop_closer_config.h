// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/loops/acceptance/agreement.h"
#include "revisit_slam/loops/registration/fine_registration_config.h"
#include "revisit_slam/loops/association/submap_association.h"

namespace revisit_slam {

/// From a pair of local maps to constraints between their submaps (paper Sec. III-C).
struct LoopCloserConfig {
  AssociationConfig association;
  FineRegistrationConfig registration;
  double min_fitness = 0.25;
  double min_coherence = 0.5;
  double max_translation = 6.0;
  double max_rotation = 15.0;
  AgreementConfig agreement;

  template <typename Visitor>
  void visit(Visitor& v) {
    v.group("association", association);
    v.group("registration", registration);
    v("min_fitness", min_fitness, Range{0.0, 1.0}, "", "tau_f, share of voxels with a counterpart");
    v("min_coherence", min_coherence, Range{0.0, 1.0}, "",
      "share of surfaces that fit where there are surfaces near, halfway from it to 1 for a "
      "retroactive pair alone; 0 switches the check off");
    v("max_translation", max_translation, Range{0.0, 1000.0}, "m",
      "a registration that moved farther from its guess is rejected");
    v("max_rotation", max_rotation, Range{0.0, 180.0}, "deg",
      "a registration that turned farther from its guess is rejected; a third of it where no "
      "other registration of these local maps confirms it");
    v.group("agreement", agreement);
  }
};

}  // namespace revisit_slam
