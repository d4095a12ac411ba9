// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// The bird's-eye picture of a local map.
struct DensityImageConfig {
  double resolution = 0.5;
  double min_density = 0.05;
  double radius = 400.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("resolution", resolution, Range{0.05, 5.0}, "m", "edge of a pixel");
    v("min_density", min_density, Range{0.0, 1.0}, "",
      "pixels with a smaller share of the range of densities are empty");
    v("radius", radius, Range{10.0, 1000.0}, "m", "points farther from the keypose are left out");
  }
};

/// What is remembered of the picture.
struct PlaceFeaturesConfig {
  int max_features = 500;
  int fast_threshold = 35;
  int patch_size = 31;
  int self_similarity = 35;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("max_features", max_features, Range{10, 500}, "", "ORB features of an image at most");
    v("fast_threshold", fast_threshold, Range{1, 254}, "",
      "grey levels between a corner and its surroundings");
    v("patch_size", patch_size, Range{7, 101}, "px", "edge of the patch that a feature describes");
    v("self_similarity", self_similarity, Range{0, 256}, "bit",
      "a feature with another one as near as this in its own image is dropped");
  }
};

/// Defaults: Gupta et al., ICRA 2024, as MapClosures 2.2.0 has them, but for min_inliers, which is
/// one less (see docs/loops.md): what is recognised wrongly, registration does not confirm.
struct PlaceRecognitionConfig {
  DensityImageConfig image;
  PlaceFeaturesConfig features;
  int max_distance = 50;
  double inlier_radius = 3.0;
  double max_turn = 0.35;
  double separation = 5.0;
  int min_inliers = 4;
  int newest_excluded = 3;
  int samples = 5000;
  int seed = 1;

  template <typename Visitor>
  void visit(Visitor& v) {
    v.group("image", image);
    v.group("features", features);
    v("max_distance", max_distance, Range{0, 128}, "bit", "matched features differ by no more");
    v("inlier_radius", inlier_radius, Range{0.5, 20.0}, "px",
      "matched features that lie nearer to each other agree with an alignment");
    v("max_turn", max_turn, Range{0.01, 3.2}, "rad",
      "they are also turned by the angle of the alignment, within this");
    v("separation", separation, Range{0.0, 100.0}, "px",
      "of several that agree and are nearer to each other only one counts");
    v("min_inliers", min_inliers, Range{2, 500}, "",
      "tau_inliers: a place is recognised when more features than this agree");
    v("newest_excluded", newest_excluded, Range{0, 1000}, "",
      "the newest maps before the query, which are no candidates");
    v("samples", samples, Range{10, 1000000}, "", "pairs of matches tried for an alignment");
    v("seed", seed, Range{0, 1e9}, "", "of the choice among more pairs than that");
  }
};

}  // namespace revisit_slam
