// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "revisit_slam/geometry/voxel_filter.h"
#include "revisit_slam/icp/local_voxel_map.h"
#include "revisit_slam/odometry/adaptive_threshold.h"
#include "revisit_slam/odometry/fit_judge.h"
#include "revisit_slam/odometry/motion_predictor.h"
#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/odometry/preprocessing.h"
#include "revisit_slam/odometry/registration.h"
#include "revisit_slam/odometry/voxel_scale.h"
#include "revisit_slam/types/registered_scan.h"
#include "revisit_slam/util/stage_times.h"

namespace revisit_slam {

enum class OdometryOutcome {
  registered,
  duplicate_stamp,  ///< the stamp of the scan before
  time_went_back,   ///< older than the scan before
  no_point_in_range,
};

const char* toString(OdometryOutcome outcome);

/// `scan` is set when the outcome is `registered`; otherwise the scan changed nothing.
struct OdometryResult {
  OdometryOutcome outcome = OdometryOutcome::registered;
  std::optional<RegisteredScan> scan;
  std::size_t too_near = 0, too_far = 0;  ///< points dropped by range
  std::size_t on_body = 0;                ///< points dropped in the box of the robot itself
  StageTimes times;
};

/// LiDAR odometry (paper Sec. III-A; Vizzo et al., KISS-ICP, RA-L 2023): predict -> align ->
/// commit. Scans are registered to the map point to plane where it is planar (the paper's ICP is
/// point to point everywhere). The odom frame is the base frame of the first scan. A scan that does
/// not fit the map is registered from other guesses too, and where none fits it begins a new piece
/// of map at the predicted pose. Not thread-safe.
/// Runs in the current TBB arena, with the same bits for any number of threads.
class Odometry {
 public:
  explicit Odometry(const OdometryConfig& config);
  Odometry(const OdometryConfig& config, std::unique_ptr<MotionPredictor> predictor);

  /// Registers a scan to the map, from the predicted motion. The map stays as it is until commit(),
  /// so that the registration can be looked at beside it; the second scan alone corrects what the
  /// first has left there, as only then is known how that one was moved.
  OdometryResult align(const Scan& scan);

  /// Takes the scan that was aligned into the map and its motion into the prediction. There must be
  /// one.
  void commit();

  /// Both.
  OdometryResult registerScan(const Scan& scan);

  const LocalVoxelMap& map() const { return map_; }

  /// Takes over what may change between two scans: ranges, deskewing, prediction time.
  void reconfigure(const OdometryConfig& config);

 private:
  /// What one sensor saw.
  struct SeenPoints {
    Points source_base;
    Eigen::Vector3d sensor_base;
  };
  /// A scan that is aligned, and not yet in the map.
  struct Aligned {
    Stamp stamp;
    Pose T_odom_base;
    Pose deviation;       ///< T_predicted_base
    Matrix6 information;  ///< of the registration alone
    bool enters_threshold;
    Fit fit;
    bool sees_motion;
    PoseVerdict verdict;
    double reach;  ///< m, see VoxelScale
    std::optional<SeenPoints> seen;
  };

  LocalVoxelMap emptyMap(double voxel_size) const;
  void chooseScale(RegisteredScan& registered);
  void followScale(const Aligned& aligned);
  PosePrediction predictionOf(const Pose& T_odom_predicted) const;
  double sigmaFor(const PredictedMotion& predicted) const;
  void downsample(RegisteredScan& registered);
  void recover(const PredictedMotion& predicted, const RingSpacing& rings,
               RegisteredScan& registered);
  static Fit fitOf(const RegistrationResult& registration) {
    return {registration.explained, registration.explained_anywhere};
  }
  PoseVerdict verdictOn(const RegisteredScan& registered) const {
    return fit_.judge(fitOf(registered.registration), registered.source_base.size(),
                      registered.jump);
  }
  bool isContradicted(const RegisteredScan& registered) const;
  void loseTrack(const PredictedMotion& predicted, RegisteredScan& registered) const;
  void startAgain(const Scan& scan, double seconds, RegisteredScan& registered);
  void deskewAgain(RegisteredScan& registered);

  OdometryConfig config_;
  std::unique_ptr<MotionPredictor> predictor_;
  VoxelScale scale_;
  LocalVoxelMap map_;
  Registration registration_;
  Registration guesses_;  // with few iterations
  AdaptiveThreshold threshold_;
  VoxelFilter voxel_filter_;
  std::vector<float> sweep_fractions_;      // of the points of the scan
  Points map_points_base_;                  // of the scan, as they enter the map
  std::vector<float> map_sweep_fractions_;  // of these
  std::vector<float> source_sweep_fractions_;

  std::uint32_t scans_ = 0, scans_of_map_ = 0;
  FitJudge fit_;
  bool motion_is_seen_ = false;     // by a scan of the map
  int vain_recoveries_ = 0;         // in a row
  std::optional<Scan> first_scan_;  // until the second is registered
  Stamp previous_stamp_;
  Pose T_odom_previous_;
  std::optional<SeenPoints> previous_seen_;  // none of several sensors
  std::optional<Aligned> aligned_;
};

}  // namespace revisit_slam
