// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Sampling of the ICP objective around its minimum (paper Sec. III-B).
struct InformationConfig {
  bool enabled = true;
  int samples = 60;
  double translation_range = 0.1;
  double rotation_range = 0.01;
  bool full = false;
  int max_points = 250;
  double min_eigenvalue = 1e-3;
  double min_eigenvalue_share = 0.03;
  double weak_ratio = 0.1;
  double calibration = 0.08;
  double deskew_share = 1.1;
  int max_waiting = 10;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("enabled", enabled, "false: every odometry edge has the identity as information (ablation)");
    v("samples", samples, Range{42, 1000}, "", "evaluations of the objective per scan");
    v("translation_range", translation_range, Range{1e-3, 1.0}, "m",
      "perturbations reach this far along each axis");
    v("rotation_range", rotation_range, Range{1e-4, 0.1}, "rad",
      "perturbations reach this far about each axis");
    v("full", full, "all 6x6 second derivatives instead of the two 3x3 blocks");
    v("max_points", max_points, Range{100, 1000000}, "",
      "of more registered points an evenly spread subset is sampled");
    v("min_eigenvalue", min_eigenvalue, Range{1e-12, 1e3}, "",
      "smaller eigenvalues are raised to it");
    v("min_eigenvalue_share", min_eigenvalue_share, Range{0.0, 1.0}, "",
      "so are those below this share of the largest of their block: what the samples can tell "
      "apart");
    v("weak_ratio", weak_ratio, Range{0.0, 1.0}, "",
      "a direction is weak below this share of the largest eigenvalue of its block");
    v("calibration", calibration, Range{1e-3, 1e6}, "",
      "factor on the covariance of a registration, measured against ground truth");
    v("deskew_share", deskew_share, Range{0.0, 10.0}, "",
      "share of the mean change of the deskewing's error that is the deviation of a motion, "
      "measured "
      "likewise");
    v("max_waiting", max_waiting, Range{1, 10000}, "scans",
      "live: with more scans waiting the information of the scan before is repeated, and counted");
  }
};

}  // namespace revisit_slam
