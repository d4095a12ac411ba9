// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/solver.h"

#include <tbb/task_arena.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "revisit_slam/pose_graph/chain_reduction.h"
#include "revisit_slam/pose_graph/graduated_minimize.h"
#include "revisit_slam/pose_graph/graph_cost.h"

namespace revisit_slam {
namespace {

/// A start for the whole graph, with the right loops near their minimum: from the reduced graph if
/// that is much smaller, from the whole graph otherwise.
Minimum coarseSolution(const PoseGraph& graph, const MinimizeLimits& limits) {
  const ChainReduction reduction(graph);
  if (2 * reduction.reduced().poses().size() > graph.poses().size())
    return hasRedescendingKernel(graph) ? graduatedMinimize(graph, graph.poses(), limits)
                                        : Minimum{Minimization::converged, graph.poses(), 0};
  Minimum coarse = graduatedMinimize(reduction.reduced(), reduction.reduced().poses(), limits);
  if (coarse.outcome == Minimization::failed) return {coarse.outcome, graph.poses(), 0};
  coarse.poses = reduction.expand(coarse.poses);
  return coarse;
}

/// Minimises from the coarse solution, and from the given poses should that end higher than them.
Minimum fineSolution(const PoseGraph& graph, const Minimum& coarse, const MinimizeLimits& limits,
                     double initial_cost) {
  Minimum fine = minimize(graph, coarse.poses, limits);
  const bool lower = graphCost(graph, fine.poses) <= initial_cost;
  if (fine.outcome != Minimization::failed && lower) return fine;
  return minimize(graph, graph.poses(), limits);
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

std::vector<FactorResidual> residualsOf(const PoseGraph& graph, const std::vector<double>& before,
                                        const std::vector<double>& after) {
  std::vector<FactorResidual> residuals;
  residuals.reserve(before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    residuals.push_back({before[i], after[i], weightOf(graph.factors()[i].kernel, after[i])});
  return residuals;
}

/// Fills in everything but the times.
void minimizeInto(PoseGraphSolution& solution, const PoseGraph& graph, const SolverConfig& config) {
  const MinimizeLimits limits{config.max_iterations, config.function_tolerance};
  const std::vector<double> before = chi2Of(graph, graph.poses());
  solution.initial_cost = solution.final_cost = graphCost(graph, before);
  if (!std::isfinite(solution.initial_cost)) return;
  const Minimum coarse = coarseSolution(graph, limits);
  Minimum fine = fineSolution(graph, coarse, limits, solution.initial_cost);
  const std::vector<double> after = chi2Of(graph, fine.poses);
  solution.outcome = outcomeOf(fine.outcome);
  solution.poses = std::move(fine.poses);
  solution.final_cost = graphCost(graph, after);
  solution.coarse_iterations = coarse.iterations;
  solution.iterations = fine.iterations;
  solution.factors = residualsOf(graph, before, after);
}

/// Whether nothing but one chain of odometry leads to any node, and none is held.
bool isOdometryAlone(const PoseGraph& graph) {
  for (std::uint32_t i = 0; i < graph.poses().size(); ++i)
    if (graph.isHeld({i})) return false;
  std::vector<bool> reached(graph.poses().size(), false);
  for (const Factor& factor : graph.factors()) {
    const RelativePoseFactor* link = chainLink(factor);
    if (link == nullptr || reached[link->to().value]) return false;
    reached[link->to().value] = true;
  }
  return true;
}

PoseGraphSolution solveHere(const PoseGraph& graph, const SolverConfig& config) {
  PoseGraphSolution solution;
  solution.poses = graph.poses();
  solution.factors.resize(graph.factors().size());
  if (!isFinite(graph)) return solution;
  if (isOdometryAlone(graph))
    solution.outcome = SolveOutcome::no_loops;
  else
    minimizeInto(solution, graph, config);
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
