// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "revisit_slam/priors/motion_reading.h"
#include "revisit_slam/priors/priors_config.h"
#include "revisit_slam/priors/reading_buffer.h"

namespace revisit_slam {

/// The rotation of the base as a gyro has it. Its bias is what remains between the integrated and
/// the registered rotation over some seconds, at rest as in motion, about the axes about which
/// the registration knows it: registrations refer to a map, so that their errors do not add up.
class GyroPrior {
 public:
  explicit GyroPrior(const PriorsConfig& config);

  ReadingBuffer<ImuReading>& readings() { return readings_; }
  const ReadingBuffer<ImuReading>& readings() const { return readings_; }

  /// Nothing where readings are missing between the instants.
  std::optional<MeasuredMotion> motion(Stamp from, Stamp to) const;

  /// The base was registered with this motion; stamps go on from call to call. `information`: of
  /// the registration alone, of right perturbations [m; rad]: where it knows nothing the pose
  /// follows the gyro, and says nothing of its bias.
  void observe(Stamp from, Stamp to, const Pose& T_from_to, const Matrix6& information);
  /// What was measured lately is wrong, and no evidence.
  void skip() { window_ = {}; }

  const Eigen::Vector3d& bias() const { return bias_; }  ///< rad/s

 private:
  std::optional<Eigen::Quaterniond> integrate(Stamp from, Stamp to) const;
  /// Of a rotation that took so long until then, rad^2.
  double noiseVariance(Stamp to, double seconds) const;
  void estimateBias(double noise_variance);

  /// Rotations since the begin of the window, in which the bias is compared.
  struct Window {
    double seconds = 0.0;
    Eigen::Quaterniond measured = Eigen::Quaterniond::Identity();
    Eigen::Quaterniond registered = Eigen::Quaterniond::Identity();
    Eigen::Vector3d variance = Eigen::Vector3d::Zero();  // rad^2, of a registration, the largest
  };

  GyroNoiseConfig noise_;
  double max_gap_;  // s
  double gate_;
  ReadingBuffer<ImuReading> readings_;
  Eigen::Vector3d bias_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d bias_variance_;  // (rad/s)^2
  Window window_;
};

}  // namespace revisit_slam
