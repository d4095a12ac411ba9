// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "revisit_slam/odometry/motion_predictor.h"
#include "revisit_slam/priors/motion_priors.h"

namespace revisit_slam {

/// The prediction of another predictor and the motions that sensors outside have measured, weighed
/// by their covariances. A measurement that contradicts both the prediction and, scan after scan,
/// the registration loses its weight: wheels that slip, or stand on something that moves. Errors of
/// the registration last as long as what causes them is in view: beside an odometry, whose errors
/// are its own, it counts for one of many scans only (OdometryNoiseConfig::error_scans).
class FusedMotionPredictor final : public MotionPredictor {
 public:
  /// `priors` must outlive this.
  FusedMotionPredictor(const OdometryConfig& config, std::unique_ptr<MotionPredictor> predictor,
                       const PriorsConfig& priors_config, MotionPriors& priors);

  PredictedMotion predict(Stamp stamp) const override;
  void observe(Stamp stamp, const Pose& T_odom_base, const Matrix6& information) override;
  void forget() override;
  void reconfigure(const OdometryConfig& config) override { predictor_->reconfigure(config); }

 private:
  /// A measurement with the covariance by which it is weighed.
  struct Weighed {
    MotionPriors::Measurement measurement;
    Matrix6 covariance = Matrix6::Zero();
    bool is_used = false;  ///< it agrees with the prediction
    double error_scans = 1.0;
  };
  struct Fusion {
    PredictedMotion predicted;
    std::vector<Weighed> measurements;
  };
  Fusion fuse(Stamp stamp) const;
  Matrix6 covarianceOf(const PredictedMotion& predicted) const;
  SweepMotion sweepOf(const Fusion& fusion, Stamp stamp) const;
  Pose unevenness(const Fusion& fusion, Stamp stamp, double seconds) const;
  void judge(const Weighed& weighed, const Pose& T_previous_base, const Matrix6& information);

  std::unique_ptr<MotionPredictor> predictor_;
  double gate_;
  double error_scans_;
  MotionPriors& priors_;
  std::optional<Stamp> previous_stamp_;
  Pose T_odom_previous_;
  std::map<std::string, double> distrust_;  // factors on variances, by sensor that was judged
};

}  // namespace revisit_slam
