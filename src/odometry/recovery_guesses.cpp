// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/recovery_guesses.h"

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

/// Of the way that a steady motion had covered.
constexpr double kWays[] = {1.0, 0.5, 0.0, 1.5};
/// A shorter way lies within the basin of ICP, m.
constexpr double kBasin = 2.0;
/// After a pause of days no motion was steady, m.
constexpr double kFarthest = 1000.0;
constexpr double kTurns[] = {0.0, 0.26, -0.26, 0.52, -0.52, 0.79, -0.79};  // rad

}  // namespace

std::vector<Pose> recoveryGuesses(const PredictedMotion& predicted) {
  std::vector<Pose> guesses;
  const double way = predicted.velocity.velocity().head<3>().norm() * predicted.seconds_untold;
  for (const double share : kWays) {
    if (share * way > kFarthest) continue;
    const Pose moved =
        predicted.velocity.after(share * predicted.seconds_untold - predicted.extrapolated);
    for (const double turn : kTurns)
      guesses.push_back(moved * Pose{expSO3({0.0, 0.0, turn}), Eigen::Vector3d::Zero()});
    if (way < kBasin) break;
  }
  return guesses;
}

}  // namespace revisit_slam
