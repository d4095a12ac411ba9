// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/icp/local_voxel_map_config.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

struct RegistrationConfig {
  int max_iterations = 500;
  double convergence = 1e-4;
  double finest_sigma = 0.2;
  int min_correspondences = 10;
  bool planes = true;
  double within_plane_weight = 0.001;
  double scattered_points = 150.0;
  double sparse_weight = 0.02;
  double own_motion = 0.667;
  double held_weight = 500.0;
  double prediction_weight = 20.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("max_iterations", max_iterations, Range{1, 10000}, "", "ICP iterations at most");
    v("convergence", convergence, Range{1e-9, 1e-1}, "m, rad",
      "ICP ends when its step [translation; rotation] is shorter");
    v("finest_sigma", finest_sigma, Range{0.01, 1000.0}, "m",
      "once ICP has ended it goes on with half its tolerance sigma, down to this; where sigma is not "
      "larger, once is all");
    v("min_correspondences", min_correspondences, Range{6, 100000}, "",
      "with fewer matched points the pose is the prediction");
    v("planes", planes,
      "point to plane where the map points around lie in one; false: point to point everywhere");
    v("within_plane_weight", within_plane_weight, Range{0.0, 1.0}, "",
      "of the distance to a point within its plane, beside that to the plane");
    v("scattered_points", scattered_points, Range{1.0, 1e6}, "",
      "map points in the 27 voxels around, in all directions, with which a match weighs 1; with "
      "fewer it weighs less in proportion");
    v("sparse_weight", sparse_weight, Range{0.0, 1.0}, "",
      "of points with few others around, or along one line, such as a ring of the sensor");
    v("own_motion", own_motion, Range{0.0, 0.74}, "",
      "share of what the predicted motion missed with which a scan is deskewed while it is "
      "registered, in directions well held; 0: deskewed with the prediction alone");
    v("held_weight", held_weight, Range{0.0, 1e9}, "",
      "of matches that hold a direction so that half of that share remains");
    v("prediction_weight", prediction_weight, Range{0.0, 1e9}, "",
      "of the predicted motion beside those of the matches, in scans that are deskewed");
  }
};

/// The tolerance of the registration follows the errors of the motion prediction (KISS-ICP
/// Sec. III-D).
struct AdaptiveThresholdConfig {
  double initial = 2.0;
  double min_motion = 0.1;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("initial", initial, Range{1e-3, 100.0}, "m", "sigma before any motion was seen");
    v("min_motion", min_motion, Range{0.0, 10.0}, "m", "smaller prediction errors do not count");
  }
};

/// Defaults: Vizzo et al., KISS-ICP, RA-L 2023, as its release 1.3.0 has them.
struct OdometryConfig {
  double max_range = 100.0;
  double min_range = 0.5;
  bool deskew = true;
  double max_prediction_time = 1.0;
  int restart_after = 5;
  int threads = 2;
  LocalVoxelMapConfig map;
  RegistrationConfig registration;
  AdaptiveThresholdConfig threshold;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("max_range", max_range, Range{1.0, 1000.0}, "m", "points farther from the sensor are dropped");
    v("min_range", min_range, Range{0.0, 100.0}, "m", "points nearer to the sensor are dropped");
    v("deskew", deskew, "undo the motion within a scan where its point times are known");
    v("max_prediction_time", max_prediction_time, Range{0.01, 60.0}, "s",
      "the motion is extrapolated over longer gaps only this far, and the tolerance starts anew");
    v("restart_after", restart_after, Range{2, 1000}, "scans",
      "scans in a row, in order, that are older than the newest, after which a new session begins with "
      "them: the clock was set back or the recording starts over. Raise it if late scans come in long "
      "bursts; lower it if a new session should begin sooner");
    v("threads", threads, Range{1, 64}, "", "threads of the odometry; results do not depend on it");
    v.group("map", map);
    v.group("registration", registration);
    v.group("threshold", threshold);
  }
};

}  // namespace revisit_slam
