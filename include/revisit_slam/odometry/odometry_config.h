// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "revisit_slam/icp/local_voxel_map_config.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

struct RegistrationConfig {
  int max_iterations = 500;
  double convergence = 1e-4;
  double final_sigma = 0.2;
  int min_correspondences = 10;
  bool planes = true;
  double within_plane_weight = 0.001;
  double scattered_points = 150.0;
  double sparse_weight = 0.02;
  double deskew_gain = 0.667;
  double deskew_damping = 500.0;
  double prediction_weight = 20.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("max_iterations", max_iterations, Range{1, 10000}, "",
      "largest number of ICP iterations of a scan. Raise it if registrations report that it was "
      "reached; lower it to bound the time of a scan");
    v("convergence", convergence, Range{1e-9, 1e-1}, "m, rad",
      "length of the step [translation; rotation] below which ICP has converged. Raise it if "
      "registration takes too long; lower it if poses depend on the first guess");
    v("final_sigma", final_sigma, Range{0.01, 1000.0}, "m",
      "scale sigma of the robust kernel at the end of ICP: it begins with the adaptive threshold, "
      "and is halved whenever ICP has converged. Raise it if the pose slips where little but "
      "distant rings on the ground is in view (fields: 0.5); lower it if points that are new to "
      "the map pull the pose");
    v("min_correspondences", min_correspondences, Range{6, 100000}, "",
      "number of matched points below which the pose is the prediction. Raise it if few matches "
      "give wrong poses; lower it if the sensor sees few points");
    v("planes", planes,
      "true: point-to-plane residuals where the map points around are planar; false: point to "
      "point everywhere, as in KISS-ICP");
    v("within_plane_weight", within_plane_weight, Range{0.0, 1.0}, "",
      "weight of the point-to-point residual that is added to each point-to-plane residual. Raise "
      "it if the pose drifts along corridors; lower it if it lags behind along the ground");
    v("scattered_points", scattered_points, Range{1.0, 1e6}, "",
      "number of map points in the 27 voxels around a match without plane or line at which its "
      "weight is 1; with fewer points it is proportionally smaller. Raise it if vegetation "
      "disturbs the pose; lower it if little else is in view");
    v("sparse_weight", sparse_weight, Range{0.0, 1.0}, "",
      "weight of matches with few or only linear map points around, such as a single ring. Raise "
      "it "
      "if the pose slips where the map is sparse; lower it if the estimate lags behind the motion");
    v("deskew_gain", deskew_gain, Range{0.0, 0.74}, "",
      "share of the error of the predicted motion that is taken out of the points while a scan is "
      "registered; 0: points are deskewed with the prediction alone. Raise it if the pose swings "
      "with the steps of a person; lower it if the pose oscillates from scan to scan");
    v("deskew_damping", deskew_damping, Range{0.0, 1e9}, "",
      "sum of match weights in a direction at which half of deskew_gain is applied there. Raise it "
      "if the pose drifts where little constrains it (bridges); lower it if it slips in fields");
    v("prediction_weight", prediction_weight, Range{0.0, 1e9}, "",
      "weight of the predicted motion in the registration of scans that are deskewed, where a "
      "match has at most 1. Raise it if the pose drifts where little constrains it; lower it if it "
      "lags behind turns and brakes");
  }
};

/// The tolerance of the registration follows the errors of the motion prediction (KISS-ICP
/// Sec. III-D).
struct AdaptiveThresholdConfig {
  double initial = 2.0;
  double min_motion = 0.1;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("initial", initial, Range{1e-3, 100.0}, "m",
      "sigma, the expected error of the predicted motion, before any motion was seen. Raise it if "
      "drives start in motion; lower it if the first scans match wrong surfaces");
    v("min_motion", min_motion, Range{0.0, 10.0}, "m",
      "error of the predicted motion below which it does not enter sigma. Raise it if sigma "
      "becomes "
      "too small at standstill; lower it if sigma stays large in "
      "slow motion");
  }
};

/// How well a scan has to fit the map (FitJudge), in shares of what the map explains of scans of
/// late.
struct FitConfig {
  double good = 0.6;
  double lost = 0.3;
  double jump = 5.0;
  double through = 0.05;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("good", good, Range{0.0, 1.0}, "",
      "share of the usual fit (fit: share of the points of a scan that the map explains) below "
      "which a pose is poor and other first guesses are tried; 0: every pose is good. Raise it if "
      "wrong poses are called good; lower it if right ones are called poor (scans far apart, dense "
      "traffic)");
    v("lost", lost, Range{0.0, 1.0}, "",
      "share of the usual fit below which a pose is lost and a new voxel map begins; 0: never. "
      "Raise it if the map is distorted after the sensor was carried; lower it if new voxel maps "
      "begin without need");
    v("jump", jump, Range{0.0, 1000.0}, "standard deviations",
      "largest deviation of a pose from the prediction, as the motion so far and the registration "
      "let expect it, with which the pose is good; beyond, it is poor; 0: any. Raise it if right "
      "poses are called poor where the motion changes suddenly; lower it if wrong ones are called "
      "good");
    v("through", through, Range{0.0, 1.0}, "",
      "share of the points of a poor scan that were seen through surfaces of the map, beyond twice "
      "that of the scan before, from which on the pose is lost; 0: never. Raise it if new voxel "
      "maps begin without need (doors that open suddenly); lower it if the map is distorted after "
      "the sensor was carried");
  }
};

/// Defaults: Vizzo et al., KISS-ICP, RA-L 2023, as its release 1.3.0 has them.
struct OdometryConfig {
  double max_range = 100.0;
  double min_range = 0.5;
  std::string body;
  bool deskew = true;
  bool adaptive_voxel_size = true;
  bool redo_first_scans = true;
  std::string sampling = "spread";
  double max_prediction_time = 1.0;
  int restart_after = 5;
  int threads = 2;
  LocalVoxelMapConfig map;
  RegistrationConfig registration;
  AdaptiveThresholdConfig threshold;
  FitConfig fit;

  /// Empty where there is none. @throws ParameterError
  Eigen::AlignedBox3f bodyBox() const;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("max_range", max_range, Range{1.0, 1000.0}, "m",
      "distance from the sensor beyond which points are dropped. Raise it if little is near; lower "
      "it if far points are inaccurate or the map takes too much time");
    v("min_range", min_range, Range{0.0, 100.0}, "m",
      "distance from the sensor within which points are dropped. Raise it if the sensor sees "
      "the robot or the person that carries it; lower it in narrow surroundings");
    v("body", body, Choices{}, "",
      "box of the robot itself in the base frame, two opposite corners x y z x y z (m), in which "
      "points are dropped; empty: none");
    v("deskew", deskew,
      "true: points are corrected for the motion within the scan where point times are known; "
      "false: they are used as measured");
    v("adaptive_voxel_size", adaptive_voxel_size,
      "true: the voxels of the odometry's map are halved, if need be more than once, where the "
      "median distance of points is below 10 of their edges, as in rooms, or a ceiling is two to "
      "four edges above the floor, as in garages; false: map/voxel_size everywhere");
    v("redo_first_scans", redo_first_scans,
      "true: the first two scans are deskewed and registered once more with the motion between "
      "them; false: the first scan is taken as it is, as in KISS-ICP");
    v("sampling", sampling, Choices{"spread", "hash"}, "",
      "which point of a voxel is registered. spread: the first one in an order that jumps "
      "evenly over the scan; hash: the first one in the order of KISS-ICP's hash table");
    v("max_prediction_time", max_prediction_time, Range{0.01, 60.0}, "s",
      "longest time over which the motion is extrapolated; after a longer gap between scans "
      "sigma is at least threshold/initial. Raise it if scans are lost in steady motion; lower "
      "it if the motion changes quickly");
    v("restart_after", restart_after, Range{2, 1000}, "scans",
      "number of consecutive scans, in order of time, with stamps before the newest scan, after "
      "which the clock counts as set back and a new session begins with them. Raise it if late "
      "scans come in long bursts; lower it if a new session should begin sooner");
    v("threads", threads, Range{1, 64}, "",
      "number of threads of the odometry; results do not depend on it");
    v.group("map", map);
    v.group("registration", registration);
    v.group("threshold", threshold);
    v.group("fit", fit);
  }
};

}  // namespace revisit_slam
