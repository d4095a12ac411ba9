// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/icp/normal_equations.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// Keeps the rings that the sensor draws on bare ground from holding it at rest: matches of
/// ShapeKind::sparse, and the distances within planes. They move along with the sensor; so to them
/// one that begins to move rests, and to the prediction too, which follows from the scans that they
/// held. Until the motion has been seen, rings weigh no more than a small share of all else in the
/// direction of translation in which that is least, and the prediction weighs nothing in the
/// directions in which they would weigh more.
class RingLimit {
 public:
  explicit RingLimit(bool motion_is_seen) : motion_is_seen_(motion_is_seen) {}

  /// Of the weights of rings in the next normal equations, 0 … 1.
  double factor() const { return factor_; }

  /// Takes normal equations that were made with the factor.
  void update(const NormalEquations& equations);

  /// Whether rings would hold the pose if they were not limited.
  bool isNeeded() const { return factor_ < 1.0; }

  /// Without the directions that rings would hold. `weight`: of the prediction, in the base frame.
  Matrix6 limited(const Matrix6& weight) const;

 private:
  bool motion_is_seen_;
  double factor_ = 1.0;
  Matrix6 seen_ = Matrix6::Identity();  // projects onto what rings do not hold
};

}  // namespace revisit_slam
