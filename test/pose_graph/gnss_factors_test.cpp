// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/gnss_factors.h"

#include <gtest/gtest.h>

#include "graph_fixtures.h"
#include "revisit_slam/pose_graph/slam_graph.h"

namespace revisit_slam {
namespace {

constexpr std::uint32_t kNodes = 400;
const GeodeticPosition kDatum{48.1, 11.6, 520.0};
const Eigen::Vector3d kAntenna(-0.5, 0.3, 1.6);

/// A drive of 2 m a scan through a wide bend.
Pose trueStep() {
  return {expSO3({0.0, 0.0, 0.003}), {2.0, 0.0, 0.0}};
}

/// In east, north and up.
std::vector<Pose> trueDrive() {
  std::vector<Pose> truth{{expSO3({0.0, 0.0, 1.2}), {300.0, -200.0, 5.0}}};
  while (truth.size() < kNodes) truth.push_back(truth.back() * trueStep());
  return truth;
}

/// What one of the drives is like.
struct Drive {
  double turn_error = 2e-4;  ///< rad a scan: the odometry bends
  double noise = 1.5;        ///< m
  std::uint32_t jump_from = 0, jump_end = 0;
  Eigen::Vector3d jump{0.0, 30.0, 0.0};
  std::uint32_t outage_from = 0, outage_end = 0;
};

GnssConfig connected() {
  GnssConfig config;
  config.topic = "/fix";
  config.datum = "48.1 11.6 520";
  return config;
}

std::vector<GraphNode> nodesOf(const Drive& drive) {
  const std::vector<Pose> truth = trueDrive();
  const LocalEnu enu(kDatum);
  RandomNumbers random(3);
  std::vector<GraphNode> nodes;
  Pose T_odom_base;
  const auto in = [](std::uint32_t i, std::uint32_t from, std::uint32_t end) {
    return from <= i && i < end;
  };
  for (std::uint32_t i = 0; i < kNodes; ++i) {
    if (i > 0) T_odom_base = T_odom_base * boxplus(trueStep(), drive.turn_error * Tangent::Unit(5));
    GraphNode node{ScanId{i}, Stamp{i}, T_odom_base, correlatedInformation(0.01, 1e-4), {}};
    if (i % 2 == 0 && !in(i, drive.outage_from, drive.outage_end)) {
      GnssFix fix;
      fix.scan = ScanId{i > 4 ? i - 4 : 0};  // it came late
      fix.p_scan = kAntenna;
      Eigen::Vector3d p_enu = truth[fix.scan.value] * kAntenna;
      for (int axis = 0; axis < 3; ++axis)
        p_enu[axis] += random.gaussian((axis == 2 ? 2.0 : 1.0) * drive.noise);
      if (in(i, drive.jump_from, drive.jump_end)) p_enu += drive.jump;
      fix.position = enu.toGeodetic(p_enu);
      fix.covariance_enu.diagonal() << 1.0, 1.0, 4.0;
      fix.covariance_enu *= drive.noise * drive.noise;
      node.fixes = {fix};
    }
    nodes.push_back(node);
  }
  return nodes;
}

SlamGraph graphOf(const Drive& drive, const GnssConfig& config = connected()) {
  SlamGraph graph({}, config);
  for (const GraphNode& node : nodesOf(drive)) graph.add(node);
  return graph;
}

/// m, on the earth.
double absoluteError(const SlamGraph& graph) {
  std::vector<Pose> poses = graph.poses();
  for (Pose& T : poses) T = graph.georeference()->T_enu_map * T;
  return positionError(poses, trueDrive());
}

double largestStepError(const SlamGraph& graph) {
  const std::vector<Pose> poses = graph.poses();
  double largest = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i)
    largest = std::max(
        largest, ((poses[i - 1].inverse() * poses[i]).translation - trueStep().translation).norm());
  return largest;
}

TEST(GnssFactors, StraightenADriveAndPlaceItOnTheEarth) {
  SlamGraph graph = graphOf({});
  EXPECT_TRUE(graph.hasNewMeasurements(ScanId{kNodes - 1}));
  ASSERT_TRUE(graph.optimise(ScanId{kNodes - 1}, {}));
  ASSERT_TRUE(graph.georeference());
  EXPECT_LT(absoluteError(graph), 0.8);  // of positions that err by 3.7 m
  EXPECT_LT(largestStepError(graph), 0.1);
  EXPECT_EQ(graph.georeference()->fixes, kNodes / 2);
  EXPECT_LT(graph.georeference()->outliers, 4u);
  EXPECT_FALSE(graph.hasNewMeasurements(ScanId{kNodes - 1}));
  EXPECT_EQ(graph.lastSolution().outcome, SolveOutcome::converged);
}

TEST(GnssFactors, TheMapStaysWhereItsFirstScanIs) {
  SlamGraph graph = graphOf({});
  for (const std::uint32_t last : {100u, 250u, kNodes - 1}) {
    graph.optimise(ScanId{last}, {});
    EXPECT_LT(graph.pose(ScanId{0}).translation.norm(), 1e-9);
    EXPECT_LT(graph.pose(ScanId{0}).angle(), 1e-9);
  }
}

TEST(GnssFactors, JumpsAndOutagesDoNotTearTheMap) {
  Drive drive;
  drive.jump_from = 150;
  drive.jump_end = 180;
  drive.outage_from = 250;
  drive.outage_end = 320;
  SlamGraph graph = graphOf(drive);
  for (std::uint32_t last = 49; last < kNodes; last += 50) graph.optimise(ScanId{last}, {});
  EXPECT_LT(absoluteError(graph), 1.0);
  EXPECT_LT(largestStepError(graph), 0.1);
  EXPECT_GE(graph.georeference()->outliers, 15u);
}

/// Of the drive without positions, as session 0, and once more with them, as session 1.
SlamGraph graphOfTwoSessions() {
  SlamGraph graph({}, connected());
  for (GraphNode node : nodesOf({})) {
    node.fixes.clear();
    graph.add(node);
  }
  for (GraphNode node : nodesOf({})) {
    node.id.session = SessionId{1};
    for (GnssFix& fix : node.fixes) fix.scan.session = SessionId{1};
    graph.add(node);
  }
  return graph;
}

TEST(GnssFactors, CountAtTheScansOfTheirSessionOnceItIsInTheMap) {
  SlamGraph graph = graphOfTwoSessions();
  const ScanId last{kNodes - 1, SessionId{1}};
  graph.optimise(last, {});
  EXPECT_FALSE(graph.georeference());
  LoopConstraint loop;
  loop.constraint = {ScanId{0}, ScanId{0, SessionId{1}}, Pose::identity(),
                     correlatedInformation(0.01, 0.0005)};
  loop.source.session = SessionId{1};
  ASSERT_TRUE(graph.optimise(last, {loop}));
  ASSERT_TRUE(graph.georeference());
  EXPECT_EQ(graph.georeference()->fixes, kNodes / 2);
  EXPECT_LT(graph.georeference()->outliers, 4u);
  std::vector<Pose> poses = graph.poses();
  poses.erase(poses.begin(), poses.begin() + kNodes);
  for (Pose& T : poses) T = graph.georeference()->T_enu_map * T;
  EXPECT_LT(positionError(poses, trueDrive()), 0.8);
}

TEST(GnssFactors, TooFewPositionsLeaveTheOdometry) {
  SlamGraph graph = graphOf({});
  EXPECT_TRUE(graph.optimise(ScanId{9}, {}));
  EXPECT_FALSE(graph.georeference());
  for (const GraphNode& node : graph.nodes())
    EXPECT_LT((graph.pose(node.id).translation - node.T_odom_base.translation).norm(), 1e-9);
}

TEST(GnssFactors, ADatumFarAwayChangesItsFrameAlone) {
  GnssConfig far = connected();
  far.datum = "48.9 12.5 100";
  SlamGraph graph = graphOf({}), other = graphOf({}, far);
  graph.optimise(ScanId{kNodes - 1}, {});
  other.optimise(ScanId{kNodes - 1}, {});
  EXPECT_EQ(graph.poses().back().translation, other.poses().back().translation);
  const auto ecefOf = [](const SlamGraph& any) {
    return LocalEnu(any.georeference()->datum).T_ecef_enu() * any.georeference()->T_enu_map;
  };
  EXPECT_LT((ecefOf(graph).translation - ecefOf(other).translation).norm(), 1e-6);
}

TEST(GnssFactors, WithoutADatumTheFirstPositionIsIt) {
  GnssConfig config = connected();
  config.datum.clear();
  SlamGraph graph = graphOf({}, config);
  graph.optimise(ScanId{kNodes - 1}, {});
  const GeodeticPosition first = graph.nodes()[0].fixes[0].position;
  EXPECT_EQ(graph.georeference()->datum.latitude, first.latitude);
  EXPECT_LT((graph.georeference()->T_enu_map.translation).norm(), 8.0);
}

/// Receivers say 0, 0 before they know.
TEST(GnssFactors, AFirstPositionFarFromAllOthersIsAnOutlierAndNothingElse) {
  for (const char* datum : {"48.1 11.6 520", ""}) {
    GnssConfig config = connected();
    config.datum = datum;
    std::vector<GraphNode> nodes = nodesOf({});
    nodes[0].fixes[0].position = {0.0, 0.0, 0.0};
    SlamGraph graph({}, config);
    for (const GraphNode& node : nodes) graph.add(node);
    ASSERT_TRUE(graph.optimise(ScanId{kNodes - 1}, {}));
    ASSERT_TRUE(graph.georeference());
    EXPECT_NEAR(graph.georeference()->datum.latitude, 48.1, 0.01);
    EXPECT_GE(graph.georeference()->outliers, 1u);
    if (!std::string(datum).empty()) {
      EXPECT_LT(absoluteError(graph), 0.8);
    }
  }
}

/// As after a crash: all that was driven is added, then what the graph did is done once more.
TEST(GnssFactors, TheOriginDoesNotDependOnWhatComesAfterTheOptimisation) {
  std::vector<GraphNode> nodes = nodesOf({});
  for (std::size_t i = 100; i < nodes.size(); ++i)  // most of the drive is far away
    for (GnssFix& fix : nodes[i].fixes) fix.position.latitude += 0.2;
  GnssConfig config = connected();
  config.datum.clear();
  SlamGraph live({}, config), again({}, config);
  for (std::size_t i = 0; i < 100; ++i) live.add(nodes[i]);
  ASSERT_TRUE(live.optimise(ScanId{99}, {}));
  for (const GraphNode& node : nodes) again.add(node);
  ASSERT_TRUE(again.optimise(ScanId{99}, {}));
  ASSERT_TRUE(live.georeference());
  EXPECT_EQ(live.georeference()->datum.latitude, again.georeference()->datum.latitude);
  for (std::uint32_t i = 0; i < 100; ++i)
    ASSERT_EQ(live.pose(ScanId{i}).translation, again.pose(ScanId{i}).translation) << i;
}

TEST(GnssFactors, TheDatumOfAMapIsTakenWhereNoneIsGiven) {
  const GeodeticPosition map{-33.5, 151.25, 12.5};
  GnssConfig config = connected();
  EXPECT_EQ(config.withDatumOf(map).datum, config.datum);
  config.datum.clear();
  EXPECT_EQ(config.withDatumOf(std::nullopt).datum, "");
  const auto taken = config.withDatumOf(map).givenDatum();
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->latitude, map.latitude);
  EXPECT_EQ(taken->longitude, map.longitude);
  EXPECT_EQ(taken->altitude, map.altitude);
}

TEST(GnssFactors, ADatumThatIsNoneIsRefused) {
  for (const char* datum : {"48.1", "48.1 11.6", "91 0 0", "a b c", "1 2 3 4"}) {
    GnssConfig config;
    config.datum = datum;
    EXPECT_THROW(GnssFactors{config}, ParameterError) << datum;
  }
}

}  // namespace
}  // namespace revisit_slam
