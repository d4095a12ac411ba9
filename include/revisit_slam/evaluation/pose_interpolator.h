// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/io/trajectory.h"

namespace revisit_slam {

/// The pose of a trajectory at an instant, or why there is none.
struct PoseAnswer {
  enum class Kind { found, outside, in_gap };
  Kind kind = Kind::outside;
  Pose T_world_base;

  explicit operator bool() const { return kind == Kind::found; }
};

/// A trajectory between its poses: positions linearly, rotations by slerp.
class PoseInterpolator {
 public:
  /// Longest time between two neighbouring poses that is interpolated over, seconds.
  static constexpr double kLongestGap = 1.0;
  /// So far beyond its ends the trajectory keeps its last pose, seconds: stamps may be rounded.
  static constexpr double kBeyond = 0.001;

  /// Sorts by stamp; of several poses with one stamp the first stays.
  explicit PoseInterpolator(Trajectory trajectory, double longest_gap = kLongestGap);

  PoseAnswer at(Stamp stamp) const;
  const Trajectory& poses() const { return poses_; }

 private:
  Trajectory poses_;
  double longest_gap_;
};

}  // namespace revisit_slam
