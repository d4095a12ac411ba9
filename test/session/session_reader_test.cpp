// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "revisit_slam/session/map_export.h"
#include "revisit_slam/session/stored_local_map.h"
#include "revisit_slam/session/stored_submap.h"
#include "session/session_fixtures.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

class SessionReaderTest : public testing::Test {
 protected:
  SessionReaderTest() { writeStreetSession(path_); }

  Session read() {
    notices_.clear();
    return readSession(path_, notices_);
  }
  void overwrite(const std::string& name, const std::string& bytes) {
    std::ofstream(path_ + name, std::ios::binary) << bytes;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("session");
  std::vector<std::string> notices_;
};

TEST_F(SessionReaderTest, WhatWasWrittenIsRead) {
  const Session session = read();
  const StreetDrive& drive = StreetDrive::get();
  EXPECT_TRUE(notices_.empty()) << notices_.front();
  EXPECT_TRUE(session.info.closed);
  EXPECT_EQ(session.info.sensor, "topic /points");
  EXPECT_EQ(session.info.parameters, someInfo().parameters);
  ASSERT_EQ(session.submaps.size(), drive.updates.size());
  ASSERT_EQ(session.graph.nodes.size(), drive.nodes.size());
  for (std::size_t i = 0; i < drive.nodes.size(); ++i) {
    EXPECT_EQ(session.graph.nodes[i].stamp, drive.nodes[i].stamp);
    EXPECT_EQ(session.graph.T_map_scan[i].translation, drive.nodes[i].T_odom_base.translation);
  }
}

TEST_F(SessionReaderTest, ALogThatIsCutAnywhereGivesWhatComesBefore) {
  const std::string log = textOf(path_ + "/graph.log");
  std::size_t most = 0;
  for (std::size_t size = graphLogHeader().size(); size < log.size(); size += 97) {
    overwrite("/graph.log", log.substr(0, size));
    const Session session = read();
    EXPECT_EQ(notices_.empty(), size == graphLogHeader().size()) << size;
    EXPECT_GE(session.submaps.size(), most);
    most = session.submaps.size();
    if (!session.submaps.empty()) {
      EXPECT_LT(session.submaps.back().last_scan.value, session.graph.nodes.size());
    }
  }
  EXPECT_EQ(most, StreetDrive::get().updates.size() - 1);
}

TEST_F(SessionReaderTest, ASubmapThatIsMissingOrDamagedIsNamedAndTheOthersAreTheMap) {
  const std::string whole = textOf(submapFile(path_, SubmapId{0}));
  const auto export_notices = [&] { return exportSession(read(), folder_.file("out")); };
  EXPECT_TRUE(export_notices().empty());
  const auto all = std::filesystem::file_size(folder_.file("out/map.pcd"));
  overwrite("/submaps/000000.rsm", whole.substr(0, whole.size() / 2));
  for (const char* reason : {"is cut", "No such file"}) {
    const std::vector<std::string> notices = export_notices();
    ASSERT_EQ(notices.size(), 1u);
    EXPECT_TRUE(contains(notices.front(), reason));
    EXPECT_TRUE(contains(notices.front(), "without submap 0"));
    EXPECT_LT(std::filesystem::file_size(folder_.file("out/map.pcd")), all);
    std::filesystem::remove(submapFile(path_, SubmapId{0}));
  }
}

/// With right checksums: nothing but the contents tells.
TEST_F(SessionReaderTest, EntriesThatCannotBeEndTheLogAndNothingElse) {
  const std::string log = textOf(path_ + "/graph.log");
  const StreetDrive& drive = StreetDrive::get();
  const std::size_t submaps = drive.updates.size();
  ScansAdded elsewhere{{drive.nodes.back()}};
  elsewhere.nodes[0].id.value = static_cast<std::uint32_t>(drive.nodes.size());
  ScansAdded nowhere = elsewhere;
  ScansAdded timeless = elsewhere, weightless = elsewhere;
  timeless.nodes[0].stamp.nanoseconds = std::numeric_limits<std::int64_t>::max();
  weightless.nodes[0].information(0, 0) = 1e200;
  GnssFix exact;
  exact.position = {48.0, 11.0, 500.0};
  exact.covariance_enu.setZero();
  elsewhere.nodes[0].id.session.value = 7;
  nowhere.nodes[0].T_odom_base.translation.x() = std::nan("");
  SubmapClosed foreign = closedOf(*drive.updates[0]->submap, {});
  foreign.id.value = static_cast<std::uint32_t>(submaps);
  foreign.first_scan.value = 4'000'000'000;
  foreign.last_scan.session.value = 7;
  SubmapClosed endless = closedOf(*drive.updates[0]->submap, {Eigen::Vector3f::Constant(1e30f)});
  GraphOptimised beyond;
  beyond.version = 1;
  beyond.last_scan = drive.nodes.back().id;
  beyond.constraints = {someLoop()};
  beyond.constraints[0].constraint.to.value = 4'000'000'000;
  beyond.decisions.resize(1);
  GraphOptimised undecided = beyond;
  undecided.constraints = {someLoop()};
  undecided.decisions[0].state = static_cast<LoopState>(200);
  SubmapClosed cornerless = closedOf(*drive.updates[0]->submap, {Eigen::Vector3f::Zero()});
  cornerless.box_submap.min().x() = std::nanf("");
  GraphOptimised unknown = beyond;
  unknown.constraints = {someLoop()};
  unknown.constraints[0].target.value = 1u << 30;
  GraphOptimised between_others = beyond;
  between_others.constraints = {someLoop()};
  ++between_others.constraints[0].constraint.to.value;
  const ParametersChanged unreadable{{{"backend/drift", "nan"}}};
  for (const LogEntry& entry :
       {LogEntry(elsewhere), LogEntry(nowhere), LogEntry(foreign), LogEntry(endless),
        LogEntry(cornerless), LogEntry(beyond), LogEntry(unknown), LogEntry(between_others),
        LogEntry(undecided), LogEntry(unreadable), LogEntry(timeless), LogEntry(weightless),
        LogEntry(FixesAdded{{{ScanId{0}, exact}}})}) {
    overwrite("/graph.log", log + encodeEntry(entry));
    const Session session = read();
    ASSERT_EQ(notices_.size(), 1u) << entry.index();
    EXPECT_TRUE(contains(notices_.front(), "what follows is left out")) << notices_.front();
    EXPECT_EQ(session.submaps.size(), submaps);
    EXPECT_EQ(session.graph.T_map_scan.size(), drive.nodes.size());
  }
}

/// What a good graph log says of the loop is read; of each above only what is changed is not.
TEST_F(SessionReaderTest, ALoopBetweenItsSubmapsIsRead) {
  GraphOptimised optimised;
  optimised.version = 1;
  optimised.last_scan = StreetDrive::get().nodes.back().id;
  optimised.constraints = {someLoop()};
  optimised.decisions.resize(1);
  overwrite("/graph.log", textOf(path_ + "/graph.log") + encodeEntry(LogEntry(optimised)));
  EXPECT_EQ(read().graph.loops.size(), 1u);
}

TEST_F(SessionReaderTest, ADatumThatIsNowhereIsRefused) {
  const std::string yaml = textOf(path_ + "/session.yaml");
  overwrite("/session.yaml", yaml + "datum: {latitude: 48.0, longitude: 11.0, altitude: 500}\n");
  EXPECT_TRUE(read().info.datum);
  overwrite("/session.yaml", yaml + "datum: {latitude: .nan, longitude: 11.0, altitude: 500}\n");
  EXPECT_THROW(read(), std::runtime_error);
}

TEST_F(SessionReaderTest, WithoutItsDescriptionOrLogAFolderIsRefusedWithTheReason) {
  overwrite("/graph.log", "what is this");
  EXPECT_THROW(read(), std::runtime_error);
  std::filesystem::remove(path_ + "/graph.log");
  EXPECT_THROW(read(), std::runtime_error);
  overwrite("/session.yaml", "format: 4\n");
  try {
    read();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), "format 4"));
  }
  std::filesystem::remove(path_ + "/session.yaml");
  try {
    read();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), "no session"));
  }
}

/// The files in test/session/format_1 were made from docs/session_format.md, by other software.
TEST(SessionFormat, ASessionOfFormat1IsReadAsDocumented) {
  const std::string path = "test/session/format_1";
  std::vector<std::string> notices;
  const Session session = readSession(path, notices);
  EXPECT_TRUE(notices.empty()) << notices.front();
  EXPECT_EQ(session.info.id, SessionId{5});
  EXPECT_EQ(storedParameters(session.info).mapping.detail_voxel_size, 0.5);
  ASSERT_EQ(session.submaps.size(), 2u);
  EXPECT_EQ(session.submaps[1].first_scan, (ScanId{2, SessionId{5}}));
  EXPECT_EQ(session.submaps[1].box_submap.max(), Eigen::Vector3f(7, 8, 9));
  ASSERT_EQ(session.graph.nodes.size(), 4u);
  EXPECT_EQ(session.graph.nodes[3].information(5, 5), 2.0);
  EXPECT_EQ(session.graph.T_map_scan[1].translation.x(), 4.625);
  ASSERT_EQ(session.graph.loops.size(), 1u);
  EXPECT_EQ(session.graph.loops[0].loop.origin, LoopOrigin::retroactive);
  EXPECT_EQ(session.graph.loops[0].loop.inliers, 12);
  EXPECT_EQ(session.graph.loops[0].chi2_after, 0.5);

  const MapUpdate update =
      readSubmap(submapFile(path, SubmapId{1}), {SubmapRecord::trajectory, SubmapRecord::points,
                                                 SubmapRecord::normals, SubmapRecord::occupancy});
  EXPECT_EQ(update.submap->T_odom_submap.translation.x(), 10.0);
  EXPECT_EQ(update.submap->stamps[1].nanoseconds, 1'700'000'000'300'000'000);
  EXPECT_EQ(update.submap->points[1], Eigen::Vector3f(4, 5, 6));
  EXPECT_EQ(update.submap->normals[0], Eigen::Vector3f::UnitZ());
  const auto& entry = update.occupancy->entries().at(0);
  EXPECT_EQ(entry.block, Voxel(-1, 0, 2));
  EXPECT_EQ(update.occupancy->counts(entry).hits(0), 1u);
  EXPECT_EQ(update.occupancy->counts(entry).misses(511), 1u);

  const StoredLocalMap map = readLocalMap(localMapFile(path, LocalMapId{0}));
  EXPECT_EQ(map.submaps.size(), 2u);
  EXPECT_EQ(map.features.keypoints.at(1).j, -40);
  EXPECT_EQ(map.features.descriptors.at(1)[3], 8u);

  const TemporaryFolder folder;
  EXPECT_TRUE(exportSession(session, folder.file("out")).empty());
  EXPECT_TRUE(std::filesystem::exists(folder.file("out/map.bt")));
}

}  // namespace
}  // namespace revisit_slam
