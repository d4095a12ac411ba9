// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "revisit_slam/util/parameters.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// How far two registrations between the same local maps may contradict each other: the base plus
/// what the odometry drifts over the distance between their submaps, in both local maps.
struct AgreementConfig {
  double translation = 0.3;
  double translation_drift = 0.02;
  double rotation = 1.0;
  double rotation_drift = 0.02;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("translation", translation, Range{0.0, 100.0}, "m",
      "registrations of one place agree within");
    v("translation_drift", translation_drift, Range{0.0, 1.0}, "",
      "metres more for each metre between the places");
    v("rotation", rotation, Range{0.0, 180.0}, "deg", "registrations of one place agree within");
    v("rotation_drift", rotation_drift, Range{0.0, 10.0}, "deg/m",
      "more for each metre between the places");
  }
};

/// A registered pair of submaps, and where both were in the frame that all pairs share.
struct RegisteredPair {
  Pose T_common_target;
  Pose T_common_source;
  Pose T_target_source;  ///< as registered
  double fitness;
};

/// Whether the odometry carries one registration over to the other within the tolerance.
bool agree(const RegisteredPair& a, const RegisteredPair& b, const AgreementConfig& config);

/// For each pair, whether it belongs to the majority: the pairs that agree with the one that most
/// agree with. Fewer than or exactly half of all are no majority.
/// @param others pairs of the same local maps that are among all and agree with none.
std::vector<bool> majority(const std::vector<RegisteredPair>& pairs, std::size_t others,
                           const AgreementConfig& config);

}  // namespace revisit_slam
