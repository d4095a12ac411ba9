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
    v("enabled", enabled,
      "true: odometry edges and loop constraints have the information sampled from their ICP "
      "objective; false: the identity (ablation)");
    v("samples", samples, Range{42, 1000}, "",
      "number of perturbed poses at which the ICP objective of a scan is evaluated. Raise it if "
      "the information changes much from scan to scan; lower it if estimating the information "
      "takes too long");
    v("translation_range", translation_range, Range{1e-3, 1.0}, "m",
      "largest perturbation along each axis of the base frame. Raise it if noise of the points "
      "disturbs the information; lower it if the surroundings are narrow");
    v("rotation_range", rotation_range, Range{1e-4, 0.1}, "rad",
      "largest perturbation about each axis of the base frame. Raise it if noise of the points "
      "disturbs the information; lower it if most points are far from the sensor");
    v("full", full,
      "true: all 6x6 second derivatives of the objective; false: two 3x3 blocks, for translation "
      "and rotation apart");
    v("max_points", max_points, Range{100, 1000000}, "",
      "largest number of registered points that the information is estimated from; of more an "
      "evenly spread subset. Raise it if the information of weak directions is imprecise; lower "
      "it if estimating the information takes too long");
    v("min_eigenvalue", min_eigenvalue, Range{1e-12, 1e3}, "",
      "smallest eigenvalue of the information of an edge; smaller ones are raised to this value. "
      "Raise it if the graph comes apart at single edges; lower it if edges are too stiff in "
      "directions that scans do not constrain");
    v("min_eigenvalue_share", min_eigenvalue_share, Range{0.0, 1.0}, "",
      "smallest eigenvalue as a share of the largest of the same 3x3 block; smaller ones are "
      "raised to this share. Raise it if the graph comes apart at single edges (bridges); lower "
      "it if loops correct drift along weak directions too little");
    v("weak_ratio", weak_ratio, Range{0.0, 1.0}, "",
      "share of the largest eigenvalue of the same 3x3 block below which a direction is reported "
      "as weak. Raise it if weak directions are not reported; lower it if well constrained "
      "directions are reported");
    v("calibration", calibration, Range{1e-3, 1e6}, "",
      "factor on the published covariance of a registration, measured against ground truth. Raise "
      "it if errors are larger than the covariance predicts; lower it if errors are smaller");
    v("deskew_share", deskew_share, Range{0.0, 10.0}, "",
      "factor on the mean change of the deskewing error from scan to scan; the product is added to "
      "the published covariance as a standard deviation. Raise it if the published covariance is "
      "too small in uneven motion; lower it if the covariance is too large there");
    v("max_waiting", max_waiting, Range{1, 10000}, "scans",
      "largest number of scans that may wait live for their information; with more, the estimate "
      "of the scan before is repeated, and counted. Raise it if load comes in short bursts; lower "
      "it if odometry messages come late");
  }
};

}  // namespace revisit_slam
