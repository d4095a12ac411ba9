// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/minimize.h"

#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "revisit_slam/pose_graph/factor_cost.h"
#include "revisit_slam/pose_graph/gauge.h"
#include "revisit_slam/pose_graph/pose_block.h"

namespace revisit_slam {
namespace {

/// So large that the first steps are plain Gauss-Newton steps. A loop at the end of a long chain
/// bends it as a whole; such bends have so little curvature that the damping of an ordinary trust
/// region (1e4) holds them back for tens of iterations.
constexpr double kInitialTrustRegion = 1e12;

/// From there to heavy damping while the steps are useless (each divides by 2, 4, 8, …).
constexpr int kMaxInvalidSteps = 15;

/// Ceres' own test, in parts of the tolerance: for where no step succeeds any more, as the cost
/// changes by round-off alone.
constexpr double kRestOfTolerance = 1e-2;
constexpr double kRoundOff = 1e-12;

/// Ends after a step that lowered the cost by a smaller share than the tolerance. The test that
/// Ceres makes itself comes before such a step is taken, and throws it away with the work it took.
class EndAfterSmallStep : public ceres::IterationCallback {
 public:
  explicit EndAfterSmallStep(double tolerance) : tolerance_(tolerance) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    const bool small = step.cost_change <= tolerance_ * step.cost;
    return step.iteration > 0 && step.step_is_successful && small
               ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
               : ceres::SOLVER_CONTINUE;
  }

 private:
  double tolerance_;
};

/// CHOLMOD assembles its supernodes with four OpenMP threads, however few processors there are and
/// whatever Ceres is told: on two they wait for each other for a third of the time, and take the
/// processors from the odometry.
class OneOpenMpThread {
 public:
  OneOpenMpThread() { omp_set_max_active_levels(0); }
  ~OneOpenMpThread() { omp_set_max_active_levels(levels_before_); }
  OneOpenMpThread(const OneOpenMpThread&) = delete;
  OneOpenMpThread& operator=(const OneOpenMpThread&) = delete;

 private:
  int levels_before_ = omp_get_max_active_levels();
};

ceres::Problem::Options problemOptions() {
  ceres::Problem::Options options;
  options.disable_all_safety_checks = true;  // they cost as much as building the problem
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  return options;
}

RobustKernel widened(const RobustKernel& kernel, double least_scale) {
  if (!kernel.isRedescending()) return kernel;
  if (std::isinf(least_scale)) return {};
  return {kernel.type, std::max(kernel.scale, least_scale)};
}

/// The graph as Ceres sees it.
class GraphProblem {
 public:
  GraphProblem(const PoseGraph& graph, const std::vector<Pose>& start, double least_scale)
      : problem_(problemOptions()) {
    blocks_.reserve(start.size());
    for (const Pose& T_map_node : start) blocks_.push_back(blockOf(T_map_node));
    if (blocks_.empty()) return;
    auto* manifold = new PoseManifold;  // owned by the problem
    for (PoseBlock& block : blocks_) {
      problem_.AddParameterBlock(block.data(), PoseChart::kAmbient);
      setManifold(problem_, block.data(), manifold);
    }
    for (const Factor& factor : graph.factors())
      if (!graph.isSettled(factor)) add(factor, least_scale);
    for (const NodeId id : gaugeNodes(graph))
      problem_.SetParameterBlockConstant(blocks_[id.value].data());
  }

  ceres::Solver::Summary solve(const ceres::Solver::Options& options) {
    const OneOpenMpThread one_thread;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    return summary;
  }

  std::vector<Pose> poses() const {
    std::vector<Pose> result;
    result.reserve(blocks_.size());
    for (const PoseBlock& block : blocks_) result.push_back(poseOf(block.data()));
    return result;
  }

 private:
  void add(const Factor& factor, double least_scale) {
    auto loss = makeLoss(widened(factor.kernel, least_scale));
    std::vector<double*> nodes;
    for (const NodeId node : factor.nodes()) nodes.push_back(blocks_[node.value].data());
    problem_.AddResidualBlock(makeCost(factor).release(), loss.get(), nodes);
    if (loss) losses_.push_back(std::move(loss));
  }

  std::vector<std::unique_ptr<ceres::LossFunction>> losses_;
  std::vector<PoseBlock> blocks_;
  ceres::Problem problem_;
};

ceres::Solver::Options solverOptions(const MinimizeLimits& limits) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = limits.max_iterations;
  options.function_tolerance = std::max(kRestOfTolerance * limits.function_tolerance, kRoundOff);
  options.parameter_tolerance = 1e-12;  // of the length of all poses together
  options.initial_trust_region_radius = kInitialTrustRegion;
  options.max_num_consecutive_invalid_steps = kMaxInvalidSteps;
  return options;
}

Minimization outcomeOf(const ceres::Solver::Summary& summary) {
  if (summary.termination_type == ceres::CONVERGENCE ||
      summary.termination_type == ceres::USER_SUCCESS)
    return Minimization::converged;
  if (summary.termination_type == ceres::NO_CONVERGENCE) return Minimization::max_iterations;
  return Minimization::failed;
}

bool areFinite(const std::vector<Pose>& poses) {
  return std::all_of(poses.begin(), poses.end(), [](const Pose& T) {
    return T.translation.allFinite() && T.rotation.coeffs().allFinite();
  });
}

}  // namespace

Minimum minimize(const PoseGraph& graph, const std::vector<Pose>& start,
                 const MinimizeLimits& limits, double least_scale) {
  GraphProblem problem(graph, start, least_scale);
  EndAfterSmallStep end_after_small_step(limits.function_tolerance);
  ceres::Solver::Options options = solverOptions(limits);
  options.callbacks.push_back(&end_after_small_step);
  const ceres::Solver::Summary summary = problem.solve(options);
  Minimum minimum{outcomeOf(summary), problem.poses(),
                  std::max(0, static_cast<int>(summary.iterations.size()) - 1)};
  if (minimum.outcome == Minimization::failed || !areFinite(minimum.poses))
    return {Minimization::failed, start, minimum.iterations};
  return minimum;
}

}  // namespace revisit_slam
