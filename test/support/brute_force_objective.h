// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "revisit_slam/information/information_estimator.h"
#include "revisit_slam/odometry/odometry.h"

namespace revisit_slam {

/// The same problem with every map point within reach of any sample as a candidate.
inline RegistrationProblem withAllCandidates(const RegistrationProblem& problem,
                                             const LocalVoxelMap& map, const Pose& T_odom_base) {
  const Eigen::Matrix3f R_base_odom = T_odom_base.rotationMatrix().transpose().cast<float>();
  RegistrationProblem all = problem;
  for (std::size_t chunk = 0; chunk < all.chunks.size(); ++chunk)
    for (Candidates& candidates : all.chunks[chunk]) {
      const std::size_t points = candidates.begin.size() - 1;
      candidates = Candidates();
      for (std::size_t i = 0; i < points; ++i) {
        const Eigen::Vector3f& p = all.points_base[chunk * RegistrationProblem::kChunkLength + i];
        map.forEachAround(T_odom_base * p.cast<double>(), 6.0,
                          [&](const Eigen::Vector3f& relative, float) {
                            candidates.relative_base.push_back(R_base_odom * relative);
                          });
        candidates.begin.push_back(static_cast<std::uint32_t>(candidates.relative_base.size()));
      }
    }
  return all;
}

/// For scans from `first` on, compares the objective's samples from gathered
/// candidates with those from a search of the whole surroundings in the map, bit for bit.
class BruteForceComparison {
 public:
  explicit BruteForceComparison(std::uint32_t first) : first_(first) {}

  /// With the map that the scan was registered to, before it enters it.
  void compare(const RegisteredScan& scan, const LocalVoxelMap& map) {
    if (scan.id.value < first_) return;
    const RegistrationProblem fast =
        gatherProblem(scan.source_base, map, scan.T_odom_base,
                      Registration::maxCorrespondenceDistance(scan.sigma), 250, designs_);
    const RegistrationProblem brute = withAllCandidates(fast, map, scan.T_odom_base);
    for (std::size_t k = 0; k < designs_.size(); ++k) {
      const ObjectiveSampling sampling(designs_[k], k);
      const Eigen::VectorXd a = sampling.evaluate(fast), b = sampling.evaluate(brute);
      for (Eigen::Index m = 0; m < a.size(); ++m)
        ASSERT_EQ(a[m], b[m]) << "scan " << scan.id.value << ", sample " << m;
    }
    ++compared_;
  }

  /// Registers a scan and compares on the way.
  void registerScan(Odometry& odometry, const Scan& scan) {
    const OdometryResult result = odometry.align(scan);
    ASSERT_TRUE(result.scan);
    compare(*result.scan, odometry.map());
    odometry.commit();
  }

  int compared() const { return compared_; }

 private:
  std::uint32_t first_;
  std::vector<PerturbationDesign> designs_ = makeDesigns(InformationConfig{});
  int compared_ = 0;
};

}  // namespace revisit_slam
