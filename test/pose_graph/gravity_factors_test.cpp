// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/gravity_factors.h"

#include <gtest/gtest.h>

#include "graph_fixtures.h"
#include "revisit_slam/pose_graph/slam_graph.h"

namespace revisit_slam {
namespace {

constexpr std::uint32_t kNodes = 400;

/// Two metres a scan through bends over hills. In a bend without end a constant error of pitch
/// would look like a bias.
std::vector<Pose> trueDrive() {
  std::vector<Pose> truth{{expSO3({0.03, -0.02, 0.4}), Eigen::Vector3d::Zero()}};
  for (std::uint32_t i = 1; i < kNodes; ++i) {
    const double pitch = 0.06 * std::cos(0.05 * i) / 20.0;
    const double yaw = 0.03 * std::sin(2.0 * M_PI * i / 200.0);
    truth.push_back(truth.back() * Pose{expSO3({0.0, pitch, yaw}), {2.0, 0.0, 0.0}});
  }
  return truth;
}

struct Drive {
  double pitch_error = 5e-5;                       ///< rad a scan: the odometry bends
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();  ///< of the directions, in the base frame
  double noise = 0.001;                            ///< rad
  std::uint32_t shock_from = 0, shock_end = 0;     ///< directions between are wrong by 0.2 rad
};

std::vector<GraphNode> nodesOf(const Drive& drive) {
  const std::vector<Pose> truth = trueDrive();
  RandomNumbers random(5);
  std::vector<GraphNode> nodes;
  Pose T_odom_base;
  for (std::uint32_t i = 0; i < kNodes; ++i) {
    if (i > 0)
      T_odom_base = T_odom_base * boxplus(truth[i - 1].inverse() * truth[i],
                                          drive.pitch_error * Tangent::Unit(4));
    GraphNode node{ScanId{i}, Stamp{i}, T_odom_base, correlatedInformation(0.01, 1e-4), {}, {}};
    if (i >= 20 && i % 20 == 0) {
      const std::uint32_t scan = i - 10;
      Eigen::Vector3d up = truth[scan].rotation.conjugate() * Eigen::Vector3d::UnitZ() + drive.bias;
      for (int axis = 0; axis < 3; ++axis) up[axis] += random.gaussian(drive.noise);
      if (drive.shock_from <= scan && scan < drive.shock_end) up.x() += 0.2;
      node.gravity = GravityDirection{ScanId{scan}, up.normalized()};
    }
    nodes.push_back(node);
  }
  return nodes;
}

SlamGraph solved(const Drive& drive, const GravityConfig& config = {}) {
  BackEndConfig backend;
  backend.turn_drift = 5e-5;
  SlamGraph graph(backend, {}, config);
  for (const GraphNode& node : nodesOf(drive)) graph.add(node);
  EXPECT_TRUE(graph.optimise(ScanId{kNodes - 1}, {}));
  return graph;
}

/// rad: how far the map is bent, the largest deviation of what is up from scan to scan. Its tilt as
/// a whole is not known better than a direction.
double bendOf(const SlamGraph& graph) {
  const std::vector<Pose> truth = trueDrive();
  std::vector<Eigen::Vector3d> up_map;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::uint32_t i = 0; i < kNodes; ++i) {
    const Eigen::Vector3d up_base = truth[i].rotation.conjugate() * Eigen::Vector3d::UnitZ();
    up_map.push_back(graph.pose(ScanId{i}).rotation * up_base);
    mean += up_map.back() / kNodes;
  }
  double largest = 0.0;
  for (const Eigen::Vector3d& up : up_map) largest = std::max(largest, (up - mean).norm());
  return largest;
}

TEST(GravityFactors, KeepTheMapUpright) {
  SlamGraph bent({});
  for (GraphNode node : nodesOf({})) {
    node.gravity.reset();
    bent.add(node);
  }
  EXPECT_GT(bendOf(bent), 0.007);
  EXPECT_LT(bendOf(solved({})), 0.002);  // twice the noise of a direction
}

TEST(GravityFactors, FindTheBiasOfTheAccelerometer) {
  Drive drive;
  drive.bias = {0.015, -0.01, 0.0};
  EXPECT_LT(bendOf(solved(drive)), 0.002);
  GravityConfig unbiased;
  unbiased.bias = 1e-6;
  EXPECT_GT(bendOf(solved(drive, unbiased)), 0.004);
}

/// As of a session that was mapped with them, and is merged without.
TEST(GravityFactors, DirectionsDoNotCountWhereTheyAreSwitchedOff) {
  GravityConfig off;
  off.enabled = false;
  SlamGraph graph({}, {}, off);
  for (const GraphNode& node : nodesOf({})) graph.add(node);
  EXPECT_FALSE(graph.hasNewMeasurements(ScanId{kNodes - 1}));
  const PoseGraph plain = graph.graph();
  ASSERT_EQ(plain.factors().size(), kNodes - 1u);
  const auto& edge = std::get<RelativePoseFactor>(plain.factors()[0].measurement);
  EXPECT_EQ(edge.information, graph.nodes()[1].information);  // no drift beside it
}

TEST(GravityFactors, ShocksBendNothing) {
  Drive drive;
  drive.shock_from = 200;
  drive.shock_end = 240;
  EXPECT_LT(bendOf(solved(drive)), 0.002);
}

/// The first scan is the gauge, wherever up is.
TEST(GravityFactors, LeaveTheFirstScanWhereItIs) {
  const Pose first = solved({}).pose(ScanId{0});
  EXPECT_EQ(first.translation.norm(), 0.0);
  EXPECT_EQ(logSO3(first.rotation).norm(), 0.0);
}

TEST(GravityFactors, AreNewOnce) {
  SlamGraph graph({}, {}, {});
  const std::vector<GraphNode> nodes = nodesOf({});
  for (std::uint32_t i = 0; i < 50; ++i) graph.add(nodes[i]);
  EXPECT_FALSE(graph.hasNewMeasurements(ScanId{10}));
  EXPECT_TRUE(graph.hasNewMeasurements(ScanId{49}));
  graph.optimise(ScanId{49}, {});
  EXPECT_FALSE(graph.hasNewMeasurements(ScanId{49}));
}

}  // namespace
}  // namespace revisit_slam
