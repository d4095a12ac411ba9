// SPDX-License-Identifier: MIT
#include "revisit_slam/information/objective_sampling.h"

#include <limits>

#include "revisit_slam/icp/robust_kernel.h"
#include "revisit_slam/util/chunks.h"
#include "revisit_slam/util/vector_clones.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kVectorWidth = 8;
constexpr std::size_t kLargestBatch = 64;  // samples handled at a time, on the stack

}  // namespace

/// Adds rho(|u_m - c|^2) of the nearest candidate c to the sum of each sample of a batch.
/// The loops over samples are what the compiler vectorises.
REVISIT_SLAM_VECTOR_CLONES
void addPoint(const float* displacement, std::size_t stride, std::size_t batch, const float* p,
              const Eigen::Vector3f* candidates, std::size_t count,
              const TruncatedQuadratic& kernel, double* sums) {
  alignas(32) float ux[kLargestBatch], uy[kLargestBatch], uz[kLargestBatch], best[kLargestBatch];
  const float* D = displacement;
  for (std::size_t m = 0; m < batch; ++m) {
    ux[m] = D[m] * p[0] + D[m + stride] * p[1] + D[m + 2 * stride] * p[2] + D[m + 9 * stride];
    uy[m] = D[m + 3 * stride] * p[0] + D[m + 4 * stride] * p[1] + D[m + 5 * stride] * p[2] +
            D[m + 10 * stride];
    uz[m] = D[m + 6 * stride] * p[0] + D[m + 7 * stride] * p[1] + D[m + 8 * stride] * p[2] +
            D[m + 11 * stride];
    best[m] = std::numeric_limits<float>::max();
  }
  for (std::size_t c = 0; c < count; ++c) {
    const float x = candidates[c].x(), y = candidates[c].y(), z = candidates[c].z();
    for (std::size_t m = 0; m < batch; ++m) {
      const float dx = ux[m] - x, dy = uy[m] - y, dz = uz[m] - z;
      const float squared = dx * dx + dy * dy + dz * dz;
      best[m] = squared < best[m] ? squared : best[m];
    }
  }
  for (std::size_t m = 0; m < batch; ++m) sums[m] += kernel.rho(best[m]);
}

ObjectiveSampling::ObjectiveSampling(const PerturbationDesign& design, std::size_t index)
    : index_(index),
      samples_(design.samples().size() + 1),
      padded_((samples_ + kVectorWidth - 1) / kVectorWidth * kVectorWidth),
      displacement_(12 * padded_, 0.0f) {
  for (std::size_t m = 0; m + 1 < samples_; ++m) {
    const Pose T = exp(design.samples()[m]);
    const Eigen::Matrix3d A = T.rotationMatrix() - Eigen::Matrix3d::Identity();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        displacement_[static_cast<std::size_t>(3 * row + column) * padded_ + m] =
            static_cast<float>(A(row, column));
      displacement_[static_cast<std::size_t>(9 + row) * padded_ + m] =
          static_cast<float>(T.translation[row]);
    }
  }
}

Eigen::VectorXd ObjectiveSampling::evaluate(const RegistrationProblem& problem) const {
  const Chunks chunks(problem.chunks.size(), 1);
  std::vector<double> chunk_sums(chunks.size() * padded_, 0.0);
  chunks.forEach([&](std::size_t chunk, Chunk) {
    evaluateChunk(problem, chunk, &chunk_sums[chunk * padded_]);
  });
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(samples_));
  for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
    for (std::size_t m = 0; m < samples_; ++m)
      sums[static_cast<Eigen::Index>(m)] += chunk_sums[chunk * padded_ + m];
  return sums;
}

void ObjectiveSampling::evaluateChunk(const RegistrationProblem& problem, std::size_t chunk,
                                      double* sums) const {
  const Candidates& candidates = problem.chunks[chunk][index_];
  const TruncatedQuadratic kernel(problem.tau);
  const Eigen::Vector3f* points = &problem.points_base[chunk * RegistrationProblem::kChunkLength];
  for (std::size_t i = 0; i + 1 < candidates.begin.size(); ++i) {
    const Eigen::Vector3f* first = candidates.relative_base.data() + candidates.begin[i];
    const std::size_t count = candidates.begin[i + 1] - candidates.begin[i];
    for (std::size_t m = 0; m < padded_; m += kLargestBatch)
      addPoint(&displacement_[m], padded_, std::min(kLargestBatch, padded_ - m), points[i].data(),
               first, count, kernel, sums + m);
  }
}

}  // namespace revisit_slam
