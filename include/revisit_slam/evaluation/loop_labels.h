// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// How a place was passed again: with the same heading within 45 degrees and less (same) or more
/// (lateral) than 2 m aside, beyond 135 degrees (opposite), or between (crossing).
enum class PassKind { same, lateral, opposite, crossing };
constexpr std::size_t kPassKinds = 4;

const char* toString(PassKind kind);

/// A part of a drive, scan by scan: in the frame of its map as the odometry had it, and in truth.
struct Stretch {
  std::vector<Pose> T_map_scan;
  std::vector<Pose> T_world_scan;
};

/// What the truth says about two stretches.
struct LoopLabel {
  /// Where the source lies in the target, from all scans within 20 m of those at which they are
  /// closest: neither the odometry's drift on the way there from the keyposes nor the noise of a
  /// keypose is an error of a loop closure.
  Pose T_target_source;
  Eigen::Vector3d closest_source;  ///< that place in the source's frame
  double distance = 0.0;           ///< m, there
  /// Metres of the source's way within 8 m, and 1.5 m in height, of the target's, by kind.
  std::array<double, kPassKinds> shared{};
  Pose T_keyposes;  ///< the true pose of the source's first scan in that of the target

  double sharedPath() const;
  PassKind kind() const;  ///< most of the shared path
  /// Enough of the way is shared for a closure to be asked for: 20 m, 10 m where it is a crossing.
  bool isRevisit() const;
};

/// Neither may be empty.
LoopLabel labelOf(const Stretch& source, const Stretch& target);

struct LoopError {
  double translation = 0.0;  ///< m
  double rotation = 0.0;     ///< degrees

  bool within(double max_translation, double max_rotation) const {
    return translation < max_translation && rotation < max_rotation;
  }
};

/// At the place where source and target are closest.
LoopError errorAtPlace(const Pose& T_target_source, const LoopLabel& label);
/// At the source's keypose: what a pose graph is told.
LoopError errorAtKeypose(const Pose& T_target_source, const LoopLabel& label);

}  // namespace revisit_slam
