// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// How far two registrations between the same local maps may differ: a base plus what the odometry
/// drifts over the distance between their submaps, in both local maps.
struct PairwiseConsistencyConfig {
  double translation = 0.3;
  double translation_drift = 0.02;
  double rotation = 1.0;
  double rotation_drift = 0.02;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("translation", translation, Range{0.0, 100.0}, "m",
      "largest difference in metres between two registrations of the same local maps that are "
      "consistent. Raise it if right loops are rejected as inconsistent; lower it if wrong ones "
      "confirm each other");
    v("translation_drift", translation_drift, Range{0.0, 1.0}, "",
      "allowance for odometry drift, in metres for each metre between the submaps of the two "
      "registrations; none where the graph placed the submaps. Raise it if the odometry drifts "
      "more than this; lower it if it drifts less");
    v("rotation", rotation, Range{0.0, 180.0}, "deg",
      "largest rotation in degrees between two registrations of the same local maps that are "
      "consistent. Raise it if right loops are rejected as inconsistent; lower it if wrong ones "
      "confirm each other");
    v("rotation_drift", rotation_drift, Range{0.0, 10.0}, "deg/m",
      "allowance for odometry drift, in degrees for each metre between the submaps of the two "
      "registrations; none where the graph placed the submaps. Raise it if the odometry drifts "
      "more than this; lower it if it drifts less");
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
bool areConsistent(const RegisteredPair& a, const RegisteredPair& b,
                   const PairwiseConsistencyConfig& config);

/// For each pair, whether it belongs to the majority: the pairs that are consistent with the one
/// that most are consistent with. Half of all or fewer are no majority.
/// @param others pairs of the same local maps that are among all and consistent with none.
std::vector<bool> majority(const std::vector<RegisteredPair>& pairs, std::size_t others,
                           const PairwiseConsistencyConfig& config);

}  // namespace revisit_slam
