// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/registration/fine_registration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "revisit_slam/loops/registration/fine_registration_objective.h"
#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kChunkLength = 256;
/// Spacing of the points of a level, as part of its reach.
constexpr double kSpacing = 1.0 / 3.0;
/// With fewer voxels of one direction nothing is said about it.
constexpr std::size_t kFewestForCoherence = 50;
/// A coarse level ends when its step is below this part of its reach: the next one goes on.
constexpr double kCoarseConvergence = 4e-4;

/// Matches the samples of a chunk and adds up their normal equations. `matches`: of the iteration
/// before, and of this one afterwards.
NormalEquations linearise(const Surfels& samples, Chunk chunk, const SurfelGrid& grid,
                          const SurfelPose& T, double distance,
                          const FineRegistrationObjective& objective,
                          std::vector<const Surfel*>& matches) {
  NormalEquations equations;
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Surfel moved = T * samples[i];
    matches[i] = grid.nearest(moved.point, moved.normal, static_cast<float>(distance), matches[i]);
    if (matches[i]) objective.add(samples[i], *matches[i], T, equations);
  }
  return equations;
}

float planeDistance(const Surfel& a, const Surfel& b) {
  return std::abs((b.hasNormal() ? b.normal : a.normal).dot(a.point - b.point));
}

}  // namespace

const char* toString(FineRegistrationOutcome outcome) {
  switch (outcome) {
    case FineRegistrationOutcome::converged:
      return "converged";
    case FineRegistrationOutcome::max_iterations:
      return "stopped at the largest number of iterations";
    case FineRegistrationOutcome::too_few_correspondences:
      return "too few correspondences";
  }
  return "unknown";
}

RegistrationCloud::RegistrationCloud(const Submap& submap, const FineRegistrationConfig& config)
    : surfels_(surfelsOf(submap)), fitness_grid_(surfels_, config.fitness_distance) {
  const std::size_t count = static_cast<std::size_t>(config.points_per_level);
  for (double distance = config.coarsest_distance;; distance *= 0.5) {
    const bool finest = distance <= config.finest_distance;
    if (finest) distance = config.finest_distance;
    const Surfels surfels = finest ? surfels_ : thinned(surfels_, kSpacing * distance);
    levels_.push_back({distance, balanced(surfels, count), SurfelGrid(surfels, distance)});
    if (finest) break;
  }
}

FineRegistrationResult FineRegistration::align(const RegistrationCloud& source,
                                               const RegistrationCloud& target,
                                               const Pose& T_target_source_initial) const {
  FineRegistrationResult result;
  result.T_target_source = T_target_source_initial;
  for (std::size_t level = 0; level < source.levels_.size(); ++level) {
    const bool finest = level + 1 == source.levels_.size();
    alignLevel(source.levels_[level], target.levels_[level],
               finest ? config_.convergence : kCoarseConvergence * source.levels_[level].distance,
               result);
    if (result.outcome == FineRegistrationOutcome::too_few_correspondences) return result;
  }
  const Pose T_source_target = result.T_target_source.inverse();
  result.fitness = std::min(fitness(source, target, result.T_target_source),
                            fitness(target, source, T_source_target));
  result.coherence = std::min(coherence(source, target, result.T_target_source),
                              coherence(target, source, T_source_target));
  return result;
}

void FineRegistration::alignLevel(const RegistrationCloud::Level& source,
                                  const RegistrationCloud::Level& target, double convergence,
                                  FineRegistrationResult& result) const {
  const Chunks chunks(source.samples.size(), kChunkLength);
  const FineRegistrationObjective objective(source.distance);
  std::vector<NormalEquations> parts(chunks.size());
  std::vector<const Surfel*> matches(source.samples.size(), nullptr);
  for (int iteration = 0; iteration < config_.max_iterations; ++iteration) {
    const SurfelPose T(result.T_target_source);
    chunks.forEach([&](std::size_t index, Chunk chunk) {
      parts[index] =
          linearise(source.samples, chunk, target.grid, T, source.distance, objective, matches);
    });
    NormalEquations equations;
    for (const NormalEquations& part : parts) equations += part;
    result.inliers = equations.matches();
    result.outcome = FineRegistrationOutcome::too_few_correspondences;
    if (equations.matches() < static_cast<std::size_t>(config_.min_correspondences)) return;
    result.rms = equations.rms();
    result.outcome = FineRegistrationOutcome::max_iterations;
    const Tangent step = dampedStep(equations);
    result.T_target_source = boxplus(result.T_target_source, step);
    ++result.iterations;
    if (step.norm() < convergence) {
      result.outcome = FineRegistrationOutcome::converged;
      return;
    }
  }
}

double FineRegistration::fitness(const RegistrationCloud& a, const RegistrationCloud& b,
                                 const Pose& T_b_a) const {
  const SurfelPose T(T_b_a);
  const float reach = static_cast<float>(config_.fitness_distance);
  const float plane_reach = static_cast<float>(config_.fitness_plane_distance);
  const Chunks chunks(a.surfels_.size(), 4 * kChunkLength);
  std::vector<std::size_t> matched(chunks.size(), 0);
  chunks.forEach([&](std::size_t index, Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Surfel moved = T * a.surfels_[i];
      const Surfel* other = b.fitness_grid_.nearest(moved.point, moved.normal, reach);
      if (other && planeDistance(moved, *other) < plane_reach) ++matched[index];
    }
  });
  std::size_t sum = 0;
  for (const std::size_t count : matched) sum += count;
  return a.surfels_.empty() ? 0.0
                            : static_cast<double>(sum) / static_cast<double>(a.surfels_.size());
}

double FineRegistration::coherence(const RegistrationCloud& a, const RegistrationCloud& b,
                                   const Pose& T_b_a) const {
  const SurfelPose T(T_b_a);
  const std::size_t last = b.levels_.size() - 1, coarser = last == 0 ? 0 : last - 1;
  const RegistrationCloud::Level& level = b.levels_[coarser];
  std::array<std::size_t, kDirections> near{}, fitting{};
  for (const Surfel& surfel : a.levels_[last].samples) {
    const Surfel moved = T * surfel;
    const Surfel* other =
        level.grid.nearest(moved.point, moved.normal, static_cast<float>(level.distance));
    if (!other || !surfel.hasNormal()) continue;
    const std::size_t direction = mainDirection(surfel);
    ++near[direction];
    if (planeDistance(moved, *other) < config_.fitness_plane_distance) ++fitting[direction];
  }
  double worst = 1.0;
  for (std::size_t direction = 0; direction < kDirections; ++direction)
    if (near[direction] >= kFewestForCoherence)
      worst = std::min(
          worst, static_cast<double>(fitting[direction]) / static_cast<double>(near[direction]));
  return worst;
}

}  // namespace revisit_slam
