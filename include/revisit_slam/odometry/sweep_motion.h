// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "revisit_slam/odometry/motion.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// A motion within a sweep that was measured: the base at some instants, in its frame at the stamp
/// of the scan; between them at a constant velocity, and before the first likewise.
class SweepMotion {
 public:
  /// `T_stamp_base`: the base 1, 2, … times `step` (s) before the stamp; at least one.
  SweepMotion(double step, const std::vector<Pose>& T_stamp_base);

  /// Where a point seen by the base `seconds` from the stamp, not positive, is in the frame of the
  /// base at the stamp.
  Eigen::Vector3f carry(float seconds, const Eigen::Vector3f& point) const {
    const auto last = static_cast<int>(pieces_.size()) - 1;
    const int piece = std::min(static_cast<int>(-seconds * pieces_per_second_), last);
    const Piece& p = pieces_[static_cast<std::size_t>(piece)];
    return p.R * p.motion.carry(seconds + p.begin, point) + p.t;
  }

 private:
  /// Back from `begin` seconds before the stamp.
  struct Piece {
    float begin;
    Eigen::Matrix3f R;
    Eigen::Vector3f t;
    ConstantMotion motion;
  };
  float pieces_per_second_;
  std::vector<Piece> pieces_;
};

}  // namespace revisit_slam
