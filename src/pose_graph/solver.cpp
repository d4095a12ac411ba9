// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/solver.h"

#include <tbb/task_arena.h>

#include <chrono>
#include <cmath>

#include "revisit_slam/pose_graph/chain_reduction.h"
#include "revisit_slam/pose_graph/graduated_minimize.h"
#include "revisit_slam/pose_graph/graph_cost.h"

namespace revisit_slam {
namespace {

/// A start for the whole graph, with the right loops near their minimum: from the reduced graph if
/// that is much smaller, from the whole graph otherwise.
Minimum coarseSolution(const PoseGraph& graph, const RobustKernel& kernel,
                       const MinimizeLimits& limits) {
  const ChainReduction reduction(graph);
  if (2 * reduction.reduced().poses().size() > graph.poses().size())
    return kernel.forgetsFarLoops() ? graduatedMinimize(graph, graph.poses(), kernel, limits)
                                    : Minimum{Minimization::converged, graph.poses(), 0};
  Minimum coarse =
      graduatedMinimize(reduction.reduced(), reduction.reduced().poses(), kernel, limits);
  if (coarse.outcome == Minimization::failed) return {coarse.outcome, graph.poses(), 0};
  coarse.poses = reduction.expand(coarse.poses);
  return coarse;
}

/// Minimises from the coarse solution, and from the given poses should that end higher than them.
Minimum fineSolution(const PoseGraph& graph, const Minimum& coarse, const RobustKernel& kernel,
                     const MinimizeLimits& limits, double initial_cost) {
  Minimum fine = minimize(graph, coarse.poses, kernel, limits);
  const bool lower = graphCost(graph, fine.poses, kernel) <= initial_cost;
  if (fine.outcome != Minimization::failed && lower) return fine;
  return minimize(graph, graph.poses(), kernel, limits);
}

SolveOutcome outcomeOf(Minimization outcome) {
  switch (outcome) {
    case Minimization::converged:
      return SolveOutcome::converged;
    case Minimization::max_iterations:
      return SolveOutcome::max_iterations;
    case Minimization::failed:
      break;
  }
  return SolveOutcome::failed;
}

std::vector<LoopResidual> loopResiduals(const PoseGraph& graph, const std::vector<Pose>& solved,
                                        const RobustKernel& kernel) {
  const std::vector<double> before = chi2Of(graph.loops(), graph.poses());
  const std::vector<double> after = chi2Of(graph.loops(), solved);
  std::vector<LoopResidual> residuals;
  for (std::size_t i = 0; i < before.size(); ++i)
    residuals.push_back({before[i], after[i], weightOf(kernel, after[i])});
  return residuals;
}

/// Fills in everything but the times.
void minimizeInto(PoseGraphSolution& solution, const PoseGraph& graph, const SolverConfig& config) {
  const RobustKernel kernel{config.kernel, config.kernel_scale};
  const MinimizeLimits limits{config.max_iterations, config.function_tolerance};
  solution.initial_cost = solution.final_cost = graphCost(graph, graph.poses(), kernel);
  if (!std::isfinite(solution.initial_cost)) return;
  const Minimum coarse = coarseSolution(graph, kernel, limits);
  const Minimum fine = fineSolution(graph, coarse, kernel, limits, solution.initial_cost);
  solution.outcome = outcomeOf(fine.outcome);
  solution.poses = fine.poses;
  solution.final_cost = graphCost(graph, fine.poses, kernel);
  solution.coarse_iterations = coarse.iterations;
  solution.iterations = fine.iterations;
  solution.loops = loopResiduals(graph, fine.poses, kernel);
}

PoseGraphSolution solveHere(const PoseGraph& graph, const SolverConfig& config) {
  PoseGraphSolution solution;
  solution.poses = graph.poses();
  solution.loops.resize(graph.loops().size());
  if (graph.loops().empty()) {
    solution.outcome = isFinite(graph) ? SolveOutcome::no_loops : SolveOutcome::failed;
  } else if (isFinite(graph)) {
    minimizeInto(solution, graph, config);
  }
  return solution;
}

}  // namespace

const char* nameOf(SolveOutcome outcome) {
  switch (outcome) {
    case SolveOutcome::converged:
      return "converged";
    case SolveOutcome::max_iterations:
      return "max_iterations";
    case SolveOutcome::failed:
      return "failed";
    case SolveOutcome::no_loops:
      return "no_loops";
  }
  return "";
}

PoseGraphSolution solve(const PoseGraph& graph, const SolverConfig& config) {
  const auto start = std::chrono::steady_clock::now();
  PoseGraphSolution solution;
  tbb::task_arena arena(config.threads);
  arena.execute([&] { solution = solveHere(graph, config); });
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  solution.seconds = elapsed.count();
  return solution;
}

}  // namespace revisit_slam
