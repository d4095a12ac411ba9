// SPDX-License-Identifier: MIT
#include "revisit_slam/backend/solver.h"

#include <ceres/ceres.h>
#include <cstdlib>

#include "revisit_slam/backend/gauge.h"
#include "revisit_slam/backend/relative_pose_cost.h"
#include "revisit_slam/backend/robust_kernel.h"
namespace revisit_slam {
static double env(const char* n, double d) { const char* s = std::getenv(n); return s ? atof(s) : d; }
PoseGraphSolution solve(const PoseGraph& graph, const SolverConfig& config) {
  PoseGraphSolution solution;
  ceres::Problem::Options po; po.disable_all_safety_checks = true;
  ceres::Problem problem(po);
  std::vector<PoseBlock> blocks;
  for (auto& p : graph.poses()) blocks.push_back(blockOf(p));
  auto* m = new PoseManifold;
  std::vector<char> in(blocks.size());
  for (size_t i = 0; i < blocks.size(); ++i) { problem.AddParameterBlock(blocks[i].data(), 7); setManifold(problem, blocks[i].data(), m);}
  for (auto& c : graph.odometry()) problem.AddResidualBlock(new RelativePoseCost(c), nullptr, blocks[c.from.value].data(), blocks[c.to.value].data());
  auto loss = makeKernel(config.kernel, config.kernel_scale).release();
  for (auto& c : graph.loops()) problem.AddResidualBlock(new RelativePoseCost(c), loss, blocks[c.from.value].data(), blocks[c.to.value].data());
  for (auto g : gaugeNodes(graph)) problem.SetParameterBlockConstant(blocks[g.value].data());
  ceres::Solver::Options o;
  o.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  o.sparse_linear_algebra_library_type = env("EIGEN",0) ? ceres::EIGEN_SPARSE : ceres::SUITE_SPARSE;
  o.num_threads = config.threads;
  o.max_num_iterations = config.max_iterations;
  o.function_tolerance = config.function_tolerance;
  o.initial_trust_region_radius = env("RADIUS", 1e4);
  o.jacobi_scaling = env("JACOBI", 1) != 0;
  o.use_postordering = env("POST", 0) != 0;
  o.use_nonmonotonic_steps = env("NONMONO", 0) != 0;
  if (env("DOGLEG", 0)) { o.trust_region_strategy_type = ceres::DOGLEG; if (env("DOGLEG", 0) > 1) o.dogleg_type = ceres::SUBSPACE_DOGLEG; }
  o.max_num_consecutive_invalid_steps = 20;
  o.minimizer_progress_to_stdout = env("VERBOSE", 0) != 0;
  ceres::Solver::Summary s;
  ceres::Solve(o, &problem, &s);
  if (env("VERBOSE", 0)) puts(s.FullReport().c_str());
  for (auto& b : blocks) solution.poses.push_back(poseOf(b.data()));
  solution.initial_cost = s.initial_cost; solution.final_cost = s.final_cost; solution.iterations = (int)s.iterations.size() - 1; solution.seconds = s.total_time_in_seconds;
  solution.outcome = s.termination_type == ceres::CONVERGENCE ? SolveOutcome::converged : SolveOutcome::failed;
  return solution;
}
}  // namespace revisit_slam
