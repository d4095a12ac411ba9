// SPDX-License-Identifier: MIT
// Optimises a pose graph in g2o's format.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "revisit_slam/io/g2o.h"
#include "revisit_slam/pose_graph/chain_piece.h"
#include "revisit_slam/pose_graph/loop_kernel_config.h"
#include "revisit_slam/pose_graph/solver.h"
#include "revisit_slam/util/process_usage.h"

namespace revisit_slam {
namespace {

struct Options {
  std::string in, out;
  SolverConfig solver;
  LoopKernelConfig loop_kernel{"none"};
  bool json = false;
};

/// The poses of the file count as they are: no robust kernel unless asked for.
Options parseOptions(CLI::App& app, int argc, char** argv) {
  Options options;
  SolverConfig& solver = options.solver;
  app.add_option("graph", options.in, "g2o file with VERTEX_SE3:QUAT and EDGE_SE3:QUAT")
      ->required();
  app.add_option("--out", options.out, "g2o file for the optimised graph");
  app.add_option("--kernel", options.loop_kernel.kernel,
                 "robust kernel of all edges but those from i to i + 1; none if not given")
      ->check(CLI::IsMember({"none", "huber", "cauchy", "geman_mcclure"}));
  app.add_option("--kernel-scale", options.loop_kernel.kernel_scale,
                 "residuals well beyond lose weight");
  app.add_option("--threads", solver.threads, "threads; results do not depend on it");
  app.add_option("--max-iterations", solver.max_iterations, "steps at most");
  app.add_option("--tolerance", solver.function_tolerance, "relative decrease to end at");
  app.add_flag("--json", options.json, "print one JSON object");
  app.parse(argc, argv);
  check(parametersOf(solver));
  check(parametersOf(options.loop_kernel));
  return options;
}

/// Name and value of everything there is to say, in order.
std::vector<NamedText> report(const PoseGraph& graph, const PoseGraphSolution& solution) {
  const auto number = [](double value) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.12g", value);
    return std::string(text);
  };
  const auto odometry =
      std::count_if(graph.factors().begin(), graph.factors().end(),
                    [](const Factor& factor) { return chainLink(factor) != nullptr; });
  return {{"nodes", std::to_string(graph.poses().size())},
          {"odometry", std::to_string(odometry)},
          {"loops", std::to_string(graph.factors().size() - odometry)},
          {"initial_cost", number(solution.initial_cost)},
          {"final_cost", number(solution.final_cost)},
          {"initial_chi2_g2o", number(g2oChi2(graph, graph.poses()))},
          {"final_chi2_g2o", number(g2oChi2(graph, solution.poses))},
          {"iterations", std::to_string(solution.iterations)},
          {"coarse_iterations", std::to_string(solution.coarse_iterations)},
          {"seconds", number(solution.seconds)},
          {"peak_memory_mb", number(peakMemoryMegabytes())}};
}

void print(const std::vector<NamedText>& report, SolveOutcome outcome, bool json) {
  std::printf(json ? "{\"outcome\": \"%s\"" : "outcome %s", nameOf(outcome));
  for (const auto& [name, value] : report) {
    const bool finite = value.find_first_of("ni") == std::string::npos;  // nan and inf are not JSON
    std::printf(json ? ", \"%s\": %s" : "\n%s %s", name.c_str(),
                finite || !json ? value.c_str() : "null");
  }
  std::puts(json ? "}" : "");
}

bool run(const Options& options) {
  G2oGraph file = readG2o(options.in, options.loop_kernel.value());
  const PoseGraphSolution solution = solve(file.graph, options.solver);
  print(report(file.graph, solution), solution.outcome, options.json);
  if (solution.outcome == SolveOutcome::failed) return false;
  if (!options.out.empty()) {
    if (!solution.poses.empty()) file.graph.correct(solution.poses);
    writeG2o(options.out, file);
  }
  return true;
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  CLI::App app{"Optimises a pose graph", "optimize_graph"};
  try {
    return revisit_slam::run(revisit_slam::parseOptions(app, argc, argv)) ? 0 : 1;
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << "optimize_graph: " << error.what() << "\n";
    return 1;
  }
}
