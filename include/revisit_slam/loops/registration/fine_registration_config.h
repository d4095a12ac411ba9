// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Fine registration of two submaps (paper Sec. III-C), coarse to fine: the levels divide the
/// coarsest distances by two until they reach the finest.
struct FineRegistrationConfig {
  double coarsest_distance = 6.0;
  double finest_distance = 0.75;
  int points_per_level = 5000;
  int max_iterations = 30;
  double convergence = 2e-4;
  int min_correspondences = 200;
  double fitness_distance = 0.5;
  double fitness_plane_distance = 0.15;
  double information_voxel_size = 1.5;
  double information_distance = 0.75;

  /// For surroundings that are narrower by this factor.
  FineRegistrationConfig scaled(double scale) const {
    FineRegistrationConfig config = *this;
    for (double FineRegistrationConfig::*distance :
         {&FineRegistrationConfig::coarsest_distance, &FineRegistrationConfig::finest_distance,
          &FineRegistrationConfig::fitness_distance,
          &FineRegistrationConfig::fitness_plane_distance,
          &FineRegistrationConfig::information_voxel_size,
          &FineRegistrationConfig::information_distance})
      config.*distance *= scale;
    return config;
  }

  template <typename Visitor>
  void visit(Visitor& v) {
    v("coarsest_distance", coarsest_distance, Range{0.1, 100.0}, "m",
      "largest distance of corresponding points at the coarsest level. Raise it if first guesses "
      "are farther off; lower it if registrations converge to neighbouring structures");
    v("finest_distance", finest_distance, Range{0.05, 10.0}, "m",
      "largest distance of corresponding points at the finest level. Raise it if submaps are bent "
      "by drift; lower it if what changed between the visits pulls the pose");
    v("points_per_level", points_per_level, Range{100, 1000000}, "",
      "largest number of source points of a level, taken evenly over space and directions of "
      "normals. "
      "Raise it if registrations are imprecise; lower it if they take too long");
    v("max_iterations", max_iterations, Range{1, 1000}, "",
      "largest number of iterations of a level. Raise it if the finest level does not converge; "
      "lower "
      "it to bound the time of a registration");
    v("convergence", convergence, Range{1e-9, 1e-1}, "m, rad",
      "length of the step [translation; rotation] below which the finest level has converged. "
      "Raise "
      "it if registrations take too long; lower it if their poses depend on the first guess");
    v("min_correspondences", min_correspondences, Range{6, 1000000}, "",
      "number of matched points below which there is no result. Raise it if submaps with little in "
      "common are registered; lower it if submaps have few points");
    v("fitness_distance", fitness_distance, Range{0.05, 10.0}, "m",
      "largest distance of a voxel of one submap from its counterpart in the other; usually "
      "mapping/submap_voxel_size. Raise it if submaps are coarser; lower it if they are finer");
    v("fitness_plane_distance", fitness_plane_distance, Range{0.01, 10.0}, "m",
      "distance from the plane of the counterpart, where there is one, within which it counts. "
      "Raise "
      "it if the sensor is noisy; lower it if wrong loops have a high fitness");
    v("information_voxel_size", information_voxel_size, Range{0.1, 10.0}, "m",
      "edge of the voxels to which source points are thinned for the information, as scans are for "
      "the odometry. Raise it if loops weigh too much; lower it if they weigh too little");
    v("information_distance", information_distance, Range{0.05, 10.0}, "m",
      "tau, the truncation distance of the objective that is sampled for the information. Raise it "
      "if "
      "submaps are bent by drift; lower it if what changed between the visits counts too much");
  }
};

}  // namespace revisit_slam
