// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "revisit_slam/priors/motion_reading.h"
#include "revisit_slam/priors/priors_config.h"
#include "revisit_slam/priors/reading_buffer.h"

namespace revisit_slam {

/// The motion of the base as an odometry of the robot has it.
class OdometryPrior {
 public:
  explicit OdometryPrior(const PriorsConfig& config)
      : noise_(config.odometry), max_gap_(config.max_gap) {}

  ReadingBuffer<OdometryReading>& readings() { return readings_; }
  const ReadingBuffer<OdometryReading>& readings() const { return readings_; }

  /// Nothing where there are no readings around both instants.
  std::optional<MeasuredMotion> motion(Stamp from, Stamp to) const;

 private:
  std::optional<OdometryReading> interpolate(Stamp stamp) const;
  Matrix6 covarianceOf(const Tangent& motion, double seconds, const OdometryReading& end) const;

  OdometryNoiseConfig noise_;
  double max_gap_;  // s
  ReadingBuffer<OdometryReading> readings_;
};

}  // namespace revisit_slam
