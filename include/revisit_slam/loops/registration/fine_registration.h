// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/loops/registration/fine_registration_config.h"
#include "revisit_slam/loops/registration/fine_registration_surfels.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

enum class FineRegistrationOutcome {
  converged,
  max_iterations,           ///< the finest level did not settle; the pose is the last iterate
  too_few_correspondences,  ///< the pose is the last one that had enough
};

const char* toString(FineRegistrationOutcome outcome);

struct FineRegistrationResult {
  Pose T_target_source;
  FineRegistrationOutcome outcome = FineRegistrationOutcome::too_few_correspondences;
  int iterations = 0;       ///< of all levels
  std::size_t inliers = 0;  ///< correspondences at the last iterate
  double rms = 0.0;         ///< m, of their residuals, point to plane where there is one
  double fitness = 0.0;     ///< s_rk, 0 … 1: the smaller share of voxels with a counterpart
  /// 0 … 1, however much the submaps overlap: of the planar voxels that have a surface of the other
  /// submap near, the share that lies in it, for the main direction of normals where it is least.
  /// Where walls stand beside walls, the ground alone still makes a high fitness; this tells.
  double coherence = 0.0;
};

/// A submap made ready for registration, as source or target: thinned for each level.
class RegistrationCloud {
 public:
  RegistrationCloud(const Submap& submap, const FineRegistrationConfig& config);

 private:
  friend class FineRegistration;

  struct Level {
    double distance;  // m, reach of correspondences
    Surfels samples;  // as source
    SurfelGrid grid;  // as target
  };

  std::vector<Level> levels_;  // coarse to fine
  Surfels surfels_;            // all
  SurfelGrid fitness_grid_;
};

/// Registers one submap to another from a guess that is off by metres and degrees: point-to-plane
/// ICP on voxel means, coarse to fine, with robust weights. The reach of the correspondences halves
/// from level to level, and with it the spacing of the points and the scale of the weights.
class FineRegistration {
 public:
  explicit FineRegistration(const FineRegistrationConfig& config) : config_(config) {}

  /// Runs in the current TBB arena; the same bits for any number of threads.
  FineRegistrationResult align(const RegistrationCloud& source, const RegistrationCloud& target,
                               const Pose& T_target_source_initial) const;

 private:
  void alignLevel(const RegistrationCloud::Level& source, const RegistrationCloud::Level& target,
                  double convergence, FineRegistrationResult& result) const;

  /// Share of the voxels of a that have a counterpart in b.
  double fitness(const RegistrationCloud& a, const RegistrationCloud& b, const Pose& T_b_a) const;
  double coherence(const RegistrationCloud& a, const RegistrationCloud& b, const Pose& T_b_a) const;

  FineRegistrationConfig config_;
};

}  // namespace revisit_slam
