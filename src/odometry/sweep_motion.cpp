// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/sweep_motion.h"

#include "revisit_slam/types/se3.h"

namespace revisit_slam {

SweepMotion::SweepMotion(double step, const std::vector<Pose>& T_stamp_base)
    : pieces_per_second_(static_cast<float>(1.0 / step)) {
  Pose T_stamp_later;
  for (std::size_t i = 0; i < T_stamp_base.size(); ++i) {
    const Tangent moved = log(T_stamp_base[i].inverse() * T_stamp_later);
    pieces_.push_back({static_cast<float>(static_cast<double>(i) * step),
                       T_stamp_later.rotationMatrix().cast<float>(),
                       T_stamp_later.translation.cast<float>(), ConstantMotion(moved / step)});
    T_stamp_later = T_stamp_base[i];
  }
}

}  // namespace revisit_slam
