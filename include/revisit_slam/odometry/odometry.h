// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include <functional>
#include <optional>

#include "revisit_slam/types/registered_scan.h"
#include "revisit_slam/util/stage_times.h"
#include "revisit_slam/geometry/voxel_filter.h"
#include "revisit_slam/odometry/adaptive_threshold.h"
#include "revisit_slam/icp/local_voxel_map.h"
#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/odometry/preprocessing.h"
#include "revisit_slam/odometry/registration.h"

namespace revisit_slam {

enum class OdometryOutcome {
  registered,
  duplicate_stamp,   ///< the stamp of the scan before
  time_went_back,    ///< older than the scan before
  no_point_in_range,
};

const char* toString(OdometryOutcome outcome);

/// `scan` is set when the outcome is `registered`; otherwise the scan changed nothing.
struct OdometryResult {
  OdometryOutcome outcome = OdometryOutcome::registered;
  std::optional<RegisteredScan> scan;
  std::size_t too_near = 0, too_far = 0;  ///< points dropped by range
  StageTimes times;
};

/// LiDAR odometry (paper Sec. III-A; Vizzo et al., KISS-ICP, RA-L 2023): scan-to-map point-to-point
/// ICP from a constant-velocity prediction. The odom frame is the base frame of the first scan.
/// Not thread-safe; its own work runs on `threads` threads, with the same bits for any number.
class Odometry {
 public:
  /// Sees each registered scan with the map that it was registered to, before the scan enters it,
  /// and may add to the scan. Not called for the first scan, which is registered to nothing.
  using BeforeInsertion = std::function<void(RegisteredScan&, const LocalVoxelMap&)>;

  explicit Odometry(const OdometryConfig& config, BeforeInsertion before_insertion = {});

  OdometryResult registerScan(const Scan& scan);

  const LocalVoxelMap& map() const { return map_; }

  /// Takes over what may change between two scans: ranges, deskewing, prediction time.
  void reconfigure(const OdometryConfig& config);

 private:
  OdometryResult registerInArena(const Scan& scan);
  void downsample(RegisteredScan& registered);
  void startAgain(const Scan& scan, double seconds, RegisteredScan& registered);
  void deskewAgain(RegisteredScan& registered);
  double secondsSincePrevious(Stamp stamp) const;
  void updateMotion(const Pose& T_odom_base, double seconds);

  OdometryConfig config_;
  BeforeInsertion before_insertion_;
  tbb::task_arena arena_;
  LocalVoxelMap map_;
  Registration registration_;
  AdaptiveThreshold threshold_;
  VoxelFilter voxel_filter_;
  std::vector<float> lags_, map_lags_, source_lags_;  // of the points of the scan
  Points map_points_base_;                            // kept for its memory

  std::uint32_t scans_ = 0;
  std::optional<Scan> first_scan_;  // until the second is registered
  Stamp previous_stamp_;
  Pose T_odom_previous_;
  ConstantMotion motion_;
};

}  // namespace revisit_slam
