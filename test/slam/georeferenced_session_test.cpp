// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "revisit_slam/geometry/local_enu.h"
#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/session/map_export.h"
#include "revisit_slam/slam/graph_session.h"
#include "session/session_fixtures.h"
#include "support/contains.h"
#include "support/session_logs.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

const GeodeticPosition kDatum{48.1, 11.6, 520.0};

Pose enuToOdom() {
  return {expSO3({0.0, 0.0, 0.7}), {40.0, -20.0, 3.0}};
}

/// The drive through the street, with a position at each third scan and a direction of gravity, of
/// the scan before, at each fifth.
std::vector<GraphNode> nodesWithMeasurements() {
  const LocalEnu enu(kDatum);
  std::vector<GraphNode> nodes = StreetDrive::get().nodes;
  for (std::size_t i = 0; i < nodes.size(); i += 3) {
    GnssFix fix;
    fix.stamp = nodes[i].stamp;
    fix.scan = nodes[i].id;
    fix.p_scan = {0.0, 0.0, 2.0};
    fix.position = enu.toGeodetic(enuToOdom() * (nodes[i].T_odom_base * fix.p_scan));
    fix.covariance_enu *= 0.01;
    nodes[i].fixes.push_back(fix);
  }
  for (std::size_t i = 5; i < nodes.size(); i += 5) {
    const Pose& T_odom_base = nodes[i - 1].T_odom_base;
    nodes[i].gravity = GravityDirection{
        nodes[i - 1].id,
        T_odom_base.rotation.conjugate() * Eigen::Vector3d(0.001 * (i % 3), 0.0, 1.0).normalized()};
  }
  return nodes;
}

class GeoreferencedSession : public testing::Test {
 protected:
  GeoreferencedSession() {
    config_.gnss.topic = "/fix";
    config_.gnss.datum = "48.1 11.6 520";
    const StreetDrive& drive = StreetDrive::get();
    GraphSession session({}, config_, drive.nodes.front().stamp, {path_, "", nullptr, false},
                         [this](const MapCorrectionPtr& correction) { last_ = correction; });
    for (const GraphNode& node : nodesWithMeasurements()) session.add(node);
    for (const MapUpdatePtr& update : drive.updates) session.add(update);
    LoopClosures closures;
    closures.map = drive.updates.back()->submap->local_map;
    closures.last_scan = drive.updates.back()->submap->lastScan();
    closures.request = 1;
    session.add(closures);
    EXPECT_EQ(last_->version, 1u);
    closures.request = 2;
    session.add(closures);  // nothing is new
    EXPECT_EQ(last_->version, 0u);
    EXPECT_EQ(last_->request, 2u);
    session.writeRest();
    georeference_ = session.graph().georeference();
    T_map_scan_ = session.graph().poses();
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("session");
  SlamConfig config_;
  MapCorrectionPtr last_;
  std::optional<Georeference> georeference_;
  std::vector<Pose> T_map_scan_;
};

TEST_F(GeoreferencedSession, MeasurementsAndAlignmentAreReadAsTheyWere) {
  ASSERT_TRUE(georeference_);
  std::vector<std::string> notices;
  const Session session = readSession(path_, notices);
  EXPECT_TRUE(notices.empty()) << notices.front();
  const std::vector<GraphNode> nodes = nodesWithMeasurements();
  ASSERT_EQ(session.graph.nodes.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    ASSERT_EQ(session.graph.nodes[i].gravity.has_value(), i > 0 && i % 5 == 0);
    if (nodes[i].gravity) {
      EXPECT_EQ(session.graph.nodes[i].gravity->scan, nodes[i].gravity->scan);
      EXPECT_EQ(session.graph.nodes[i].gravity->up_base, nodes[i].gravity->up_base);
    }
    ASSERT_EQ(session.graph.nodes[i].fixes.size(), nodes[i].fixes.size());
    if (nodes[i].fixes.empty()) continue;
    EXPECT_EQ(session.graph.nodes[i].fixes[0].p_scan, nodes[i].fixes[0].p_scan);
    EXPECT_EQ(session.graph.nodes[i].fixes[0].stamp, nodes[i].fixes[0].stamp);
    EXPECT_EQ(session.graph.nodes[i].fixes[0].covariance_enu, nodes[i].fixes[0].covariance_enu);
  }
  ASSERT_TRUE(session.graph.georeference);
  EXPECT_EQ(session.graph.georeference->T_enu_map.translation,
            georeference_->T_enu_map.translation);
  ASSERT_TRUE(session.info.datum);
  EXPECT_EQ(session.info.datum->latitude, 48.1);
}

/// Where the trajectory is not in the log the graph is optimised once more, positions included.
TEST_F(GeoreferencedSession, TheGraphIsSolvedAgainFromTheLogs) {
  forgetTrajectory(path_);
  std::vector<std::string> notices;
  const Session session = readSession(path_, notices);
  EXPECT_TRUE(notices.empty()) << notices.front();
  for (std::size_t i = 0; i < T_map_scan_.size(); ++i)
    EXPECT_EQ(session.graph.T_map_scan[i].translation, T_map_scan_[i].translation) << i;
}

TEST_F(GeoreferencedSession, FilesSayWhereTheMapLies) {
  std::vector<std::string> notices;
  ExportConfig graph_alone;
  graph_alone.clouds.clear();
  graph_alone.submaps = graph_alone.occupancy = false;
  exportSession(readSession(path_, notices), folder_.file("out"), graph_alone);
  const Trajectory enu = readTum(folder_.file("out/trajectory_enu.tum"));
  const std::vector<GraphNode>& nodes = StreetDrive::get().nodes;
  ASSERT_EQ(enu.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    EXPECT_LT(
        (enu[i].T_world_base.translation - (enuToOdom() * nodes[i].T_odom_base).translation).norm(),
        0.1);
  const std::string yaml = textOf(folder_.file("out/georeference.yaml"));
  EXPECT_TRUE(contains(yaml, "epsg: 32632")) << yaml;
  EXPECT_TRUE(contains(yaml, "latitude: 48.1000000000")) << yaml;
  EXPECT_TRUE(
      contains(textOf(folder_.file("out/trajectory_utm.csv")),
               "stamp,latitude,longitude,altitude,easting,northing\n100.000000000,48.0998"));
}

}  // namespace
}  // namespace revisit_slam
