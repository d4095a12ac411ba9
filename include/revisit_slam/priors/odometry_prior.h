// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "revisit_slam/priors/motion_reading.h"
#include "revisit_slam/priors/priors_config.h"
#include "revisit_slam/priors/reading_buffer.h"

namespace revisit_slam {

/// The motion of the base as an odometry of the robot has it. Its scale (of wheels: their diameter)
/// is what remains between the measured and the registered way over some seconds, as far as the
/// registration knows it: it goes on holding where little is in view.
class OdometryPrior {
 public:
  explicit OdometryPrior(const PriorsConfig& config);

  ReadingBuffer<OdometryReading>& readings() { return readings_; }
  const ReadingBuffer<OdometryReading>& readings() const { return readings_; }

  /// Nothing where there are no readings around both instants.
  std::optional<MeasuredMotion> motion(Stamp from, Stamp to) const;

  /// The base was registered with this motion; stamps go on from call to call. A pose
  /// that follows the prediction says little of the scale.
  void observe(Stamp from, Stamp to, const Pose& T_from_to, const RegistrationEvidence& evidence);
  /// What was measured lately is wrong, and no evidence.
  void skip() { window_ = {}; }

  double scale() const { return scale_; }  ///< true metres for each that is measured

 private:
  std::optional<Pose> measure(Stamp from, Stamp to) const;
  std::optional<OdometryReading> interpolate(Stamp stamp) const;
  Matrix6 covarianceOf(const Tangent& motion, double seconds, const OdometryReading& end) const;
  void estimateScale();

  /// Ways since the begin of the window, in which the scale is compared.
  struct Window {
    double seconds = 0.0;
    double measured = 0.0;   // m
    double deviation = 0.0;  // m, by which the registered way is longer
    double variance = 0.0;   // of that, by the registration, m^2
    double share = 0.0;      // that the registration has in it, times `measured`
  };

  OdometryNoiseConfig noise_;
  double max_gap_;  // s
  double gate_;
  double scale_ = 1.0;
  double scale_variance_;
  Window window_;
  ReadingBuffer<OdometryReading> readings_;
};

}  // namespace revisit_slam
