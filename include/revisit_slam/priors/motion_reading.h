// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include "revisit_slam/priors/gnss_reading.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// What an odometry of the robot says, of the base.
struct OdometryReading {
  Stamp stamp;
  Pose T_world_base;  ///< in a world of its own; only differences are used
  /// Of its velocity, [m/s; rad/s] in the base frame; none: not known.
  std::optional<Matrix6> velocity_covariance;
  /// It knows neither height nor tilt.
  bool is_planar = false;
};

/// What an inertial unit measures, in the axes of the base.
struct ImuReading {
  Stamp stamp;
  Eigen::Vector3d turn_rate = Eigen::Vector3d::Zero();  ///< rad/s
  /// Of a turn rate, (rad/s)^2, mean of the axes; none: not known.
  std::optional<double> turn_rate_variance;
  /// As an accelerometer measures it: of a unit that rests 9.81 m/s^2 upwards; none: not measured.
  std::optional<Eigen::Vector3d> acceleration{};
  Eigen::Vector3d p_base = Eigen::Vector3d::Zero();  ///< the unit, in the base frame
};

/// What sensors beside the LiDAR measure.
using MotionReading = std::variant<OdometryReading, ImuReading, GnssReading>;

/// A motion of the base that was measured.
struct MeasuredMotion {
  Pose T_from_to;  ///< the base at the end, in its frame at the begin
  /// Of Log(T_measured^-1 T_true), [m; rad]; kUnmeasured where nothing was.
  Matrix6 covariance = Matrix6::Identity();
};

/// What a registration has to do with a pose that is made of it and of a prediction.
struct RegistrationEvidence {
  /// Of the registration alone, of right perturbations [m; rad]; singular, even zero, is welcome.
  Matrix6 information = Matrix6::Zero();
  /// How much of the registration's deviation from the prediction the pose has: near the identity
  /// where the scan decides.
  Matrix6 share = Matrix6::Identity();
};

/// A variance that says nothing, as drivers write it, too.
constexpr double kUnmeasured = 1e6;

}  // namespace revisit_slam
