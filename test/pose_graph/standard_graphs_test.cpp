// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>

#include "pose_graph/graph_fixtures.h"
#include "revisit_slam/io/g2o.h"

namespace revisit_slam {
namespace {

/// A graph that the literature compares optimisers on. The optimum is that of GTSAM 4.3.0
/// (Gauss-Newton and Levenberg-Marquardt, which agree to 1e-9), whose residual is the same
/// logarithm, with the informations converted as informationFromG2o does.
struct StandardGraph {
  const char* name;
  double optimum;
};

class StandardGraphs : public testing::TestWithParam<StandardGraph> {};

TEST_P(StandardGraphs, EndAtTheKnownOptimum) {
  const char* folder = std::getenv("REVISIT_SLAM_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "REVISIT_SLAM_TEST_DATA is not set";
  const std::string path = std::string(folder) + "/pose_graphs/" + GetParam().name + ".g2o";
  const PoseGraphSolution solution = solve(readG2o(path).graph, exactConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::converged);
  EXPECT_NEAR(solution.final_cost, GetParam().optimum, 1e-6 * GetParam().optimum);
}

INSTANTIATE_TEST_SUITE_P(All, StandardGraphs,
                         testing::Values(StandardGraph{"sphere2500", 363.642555},
                                         StandardGraph{"parking-garage", 0.6193456106},
                                         StandardGraph{"smallGrid3D", 232.072558}),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace revisit_slam
