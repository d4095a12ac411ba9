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
    v("resolution", resolution, Range{0.05, 5.0}, "m",
      "edge of a pixel of the bird's-eye density image of a local map. Raise it if recognition "
      "takes too long; lower it if the surroundings are narrow");
    v("min_density", min_density, Range{0.0, 1.0}, "",
      "point count, from 0 (one point) to 1 (the largest count of the image), up to which a pixel "
      "is empty. Raise it if ground or vegetation fills images; lower it if images are almost "
      "empty");
    v("radius", radius, Range{10.0, 1000.0}, "m",
      "horizontal distance from the keypose beyond which points are left out of the image. Raise "
      "it if distant structure is cut off; lower it if images take too much time or memory");
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
    v("max_features", max_features, Range{10, 500}, "",
      "largest number of ORB features of an image, of which the strongest are kept. Raise it if "
      "revisits are missed; lower it if recognition takes too long");
    v("fast_threshold", fast_threshold, Range{1, 254}, "",
      "smallest difference in grey levels between a corner and its surroundings. Raise it if "
      "features lie on noise; lower it if images have few features");
    v("patch_size", patch_size, Range{7, 101}, "px",
      "edge of the image patch that a feature describes; images up to twice as wide have no "
      "features. Raise it if different places look alike; lower it if local maps are small");
    v("self_similarity", self_similarity, Range{0, 256}, "bit",
      "largest difference between the descriptors of two features of one image at which both are "
      "dropped. Raise it if repeated structure is recognised wrongly; lower it if images keep few "
      "features");
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
    v("max_distance", max_distance, Range{0, 128}, "bit",
      "largest difference between the descriptors of two features that are matched. Raise it if "
      "revisits are missed; lower it if wrong matches make recognition slow or wrong");
    v("inlier_radius", inlier_radius, Range{0.5, 20.0}, "px",
      "largest distance between two matched features after alignment at which they are inliers. "
      "Raise it if drift bends local maps; lower it if wrong places are recognised");
    v("max_turn", max_turn, Range{0.01, 3.2}, "rad",
      "largest difference between the change of a feature's orientation and the rotation of the "
      "alignment, at which the match is an inlier. Raise it if revisits are missed; lower it if "
      "wrong places are recognised");
    v("separation", separation, Range{0.0, 100.0}, "px",
      "smallest distance between two inliers that both count. Raise it if a single object makes a "
      "place recognised; lower it if revisits with little structure are missed");
    v("min_inliers", min_inliers, Range{2, 500}, "",
      "tau_inliers, number of inliers that a recognised place must exceed. Raise it if wrong "
      "places are recognised; lower it if revisits are missed");
    v("newest_excluded", newest_excluded, Range{0, 1000}, "",
      "number of the newest local maps before the current one that are no candidates. Raise it if "
      "neighbours along the drive are recognised; lower it if short loops are missed");
    v("samples", samples, Range{10, 1000000}, "",
      "number of pairs of matches that are tried for an alignment; of more a random choice. Raise "
      "it if revisits are missed among many wrong matches; lower it if recognition takes too long");
    v("seed", seed, Range{0, 1e9}, "",
      "seed of the random choice among pairs of matches. Change it to see how much results depend "
      "on chance");
  }
};

}  // namespace revisit_slam
