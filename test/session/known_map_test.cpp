// SPDX-License-Identifier: MIT
#include "revisit_slam/session/known_map.h"

#include <gtest/gtest.h>

#include "revisit_slam/session/map_export.h"
#include "revisit_slam/session/stored_submap.h"
#include "session/session_fixtures.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

/// Two sessions of one street, each in a folder of its own, and both in a third one.
class KnownMapTest : public testing::Test {
 protected:
  KnownMapTest() {
    for (const std::string& path : {a_, b_}) writeStreetSession(path);
    maps_.push_back(read(a_, SessionId{0}));
    maps_.push_back(read(b_, SessionId{1}));
    notices_.clear();  // there are no places
  }

  KnownMap read(const std::string& path, std::optional<SessionId> first) {
    return readKnownMap(path, first, PlaceRecognitionConfig{}, notices_);
  }

  LoopEdge loopAcross() const {
    LoopEdge edge;
    edge.loop = someLoop();
    edge.loop.source.session = edge.loop.source_map.session = SessionId{1};
    edge.loop.constraint.to.session = SessionId{1};
    return edge;
  }

  SessionsTakenOver takenOver() const {
    SessionsTakenOver taken;
    taken.loops.push_back(loopAcross());
    for (const KnownMap& map : maps_)
      for (const GraphNode& node : map.nodes) taken.T_map_scan.push_back(placeOf(node));
    return taken;
  }
  /// The second session is 2 m above.
  static Pose placeOf(const GraphNode& node) {
    Pose T = node.T_odom_base;
    T.translation.z() += 2.0 * node.id.session.value;
    return T;
  }

  void writeBoth() {
    SessionWriter writer({both_, "", nullptr, false}, infoOfAll({&maps_[0], &maps_[1]}), 0);
    for (const KnownMap& map : maps_) copyMaps(map, writer);
    writer.add(LogEntry(takenOver()));
    writer.close();
    writer.drain();
    EXPECT_EQ(writer.problem(), "");
  }

  TemporaryFolder folder_;
  const std::string a_ = folder_.file("a"), b_ = folder_.file("b"), both_ = folder_.file("both");
  std::vector<std::string> notices_;
  std::vector<KnownMap> maps_;
};

TEST_F(KnownMapTest, NumbersStayAndSessionsAreCounted) {
  const KnownMap& b = maps_[1];
  const StreetDrive& drive = StreetDrive::get();
  ASSERT_EQ(b.nodes.size(), drive.nodes.size());
  EXPECT_EQ(b.nodes[3].id, (ScanId{3, SessionId{1}}));
  ASSERT_EQ(b.maps.size(), 1u);
  EXPECT_EQ(b.maps[0]->id, (LocalMapId{0, SessionId{1}}));
  ASSERT_EQ(b.maps[0]->submaps.size(), drive.updates.size());
  const Submap &submap = *b.maps[0]->submaps[1], &driven = *drive.updates[1]->submap;
  EXPECT_EQ(submap.first_scan, (ScanId{driven.first_scan.value, SessionId{1}}));
  EXPECT_TRUE(submap.points.empty());
  EXPECT_EQ(b.library->bytes(), 0u);
  EXPECT_EQ(b.library->whole(submap.id)->points, driven.points);
  EXPECT_EQ(submap.scale, driven.scale);
  EXPECT_EQ(read(a_, std::nullopt).maps[0]->id, LocalMapId{0});
}

TEST_F(KnownMapTest, SeveralInOneFolderAreReadAsWritten) {
  writeBoth();
  const Session session = readSession(both_, notices_);
  EXPECT_TRUE(notices_.empty()) << notices_.front();
  EXPECT_EQ(sessionsOf(session), (std::vector<SessionId>{SessionId{0}, SessionId{1}}));
  EXPECT_EQ(session.submaps.size(), maps_[0].session.submaps.size() * 2);
  ASSERT_EQ(session.graph.loops.size(), 1u);
  EXPECT_EQ(session.graph.loops[0].loop.source.session, SessionId{1});
  for (std::size_t i = 0; i < session.graph.nodes.size(); ++i)
    ASSERT_EQ(session.graph.T_map_scan[i].translation, placeOf(session.graph.nodes[i]).translation);
  ASSERT_EQ(session.info.joined.size(), 1u);
  EXPECT_EQ(session.info.joined[0].from, b_);
  EXPECT_EQ(textOf(submapFile(both_, SubmapId{1})), textOf(submapFile(a_, SubmapId{1})));
  const MapUpdate moved = readSubmap(both_ + "/submaps/1_000001.rsm", {SubmapRecord::detail});
  EXPECT_EQ(moved.submap->id, (SubmapId{1, SessionId{1}}));
  EXPECT_EQ(moved.detail_submap, StreetDrive::get().updates[1]->detail_submap);
}

TEST_F(KnownMapTest, SeveralAreReadOn) {
  writeBoth();
  const KnownMap both = read(both_, SessionId{4});
  EXPECT_EQ(both.numbers.size(), 2u);
  EXPECT_EQ(both.maps.back()->id.session, SessionId{5});
  EXPECT_EQ(both.loops.at(0).loop.source_map.session, SessionId{5});
  const SessionInfo info = infoOfAll({&maps_[0], &both});
  ASSERT_EQ(info.joined.size(), 2u);
  EXPECT_EQ(info.joined[1].id, SessionId{5});
  EXPECT_EQ(info.joined[1].from, b_);
}

TEST_F(KnownMapTest, MapsLeaveOutWhatNoLoopTies) {
  writeBoth();
  std::vector<std::string> notices =
      exportSession(readSession(both_, notices_), folder_.file("out"));
  EXPECT_TRUE(notices.empty()) << notices.front();
  EXPECT_TRUE(std::filesystem::exists(folder_.file("out/trajectory_1.tum")));
  EXPECT_TRUE(contains(textOf(folder_.file("out/loop_closures.csv")), ",0,1\n"));
  Session session = readSession(both_, notices_);
  session.graph.loops[0].state = LoopState::disabled;
  notices = exportSession(session, folder_.file("alone"));
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_TRUE(contains(notices[0], "session 1 is left out"));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("alone/submaps/1_000000.pcd")));
  EXPECT_TRUE(std::filesystem::exists(folder_.file("alone/submaps/000000.pcd")));
}

/// As where a drive goes on from a map: its folder may go once it was copied.
TEST_F(KnownMapTest, CopiesAreReadOnceTheyAreThere) {
  {
    SessionWriter writer({both_, "", nullptr, false}, infoOfAll({&maps_[0]}), 0);
    copyMaps(maps_[0], writer, true);
    writer.drain();
  }
  std::filesystem::remove_all(a_);
  EXPECT_EQ(maps_[0].library->whole(SubmapId{1})->points,
            StreetDrive::get().updates[1]->submap->points);
}

TEST_F(KnownMapTest, ASubmapThatCanNoLongerBeReadHasNoFileWhichReadersName) {
  std::filesystem::remove(submapFile(a_, SubmapId{1}));
  {
    SessionWriter writer({both_, "", nullptr, false}, infoOfAll({&maps_[0]}), 0);
    copyMaps(maps_[0], writer);
    writer.drain();
  }
  EXPECT_TRUE(std::filesystem::exists(submapFile(both_, SubmapId{0})));
  EXPECT_FALSE(std::filesystem::exists(submapFile(both_, SubmapId{1})));
  const auto notices = exportSession(readSession(both_, notices_), folder_.file("out"));
  ASSERT_FALSE(notices.empty());
  EXPECT_TRUE(contains(notices[0], "the map is without submap 1"));
}

TEST_F(KnownMapTest, ACopyThatEndedEarlySaysSo) {
  {
    SessionWriter writer({both_, "", nullptr, false}, infoOfAll({&maps_[0], &maps_[1]}), 0);
    copyMaps(maps_[0], writer);
    writer.drain();
  }
  readSession(both_, notices_);
  ASSERT_EQ(notices_.size(), 1u);
  EXPECT_TRUE(contains(notices_[0], "ended while the sessions that it goes on from were copied"));
}

TEST_F(KnownMapTest, WhatCannotBeUsedIsRefusedWithTheReason) {
  const auto problem = [&] {
    try {
      read(b_, std::nullopt);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string file = submapFile(b_, SubmapId{0}), whole = textOf(file);
  std::ofstream(file, std::ios::binary) << whole.substr(0, whole.size() / 2);
  EXPECT_TRUE(contains(problem(), "b' cannot be used"));
  EXPECT_TRUE(contains(problem(), "is cut"));
  std::ofstream(file, std::ios::binary) << textOf(submapFile(b_, SubmapId{1}));
  EXPECT_TRUE(contains(problem(), "not the one that the log tells of"));
  std::filesystem::remove(b_ + "/graph.log");
  EXPECT_FALSE(problem().empty());
}

/// As after a kill: what the graph did with the sessions taken over is done once more.
TEST_F(KnownMapTest, AGraphThatWentOnIsReplayedFromWhatWasTakenOver) {
  SlamGraph graph{BackEndConfig{}};
  graph.addOptimised(maps_[0].nodes, maps_[0].session.graph.T_map_scan, {});
  for (const GraphNode& node : maps_[1].nodes) graph.add(node);
  const LoopEdge loop = loopAcross();
  graph.optimise(maps_[1].nodes.back().id, {loop.loop});
  GraphOptimised optimised;
  optimised.version = 1;
  optimised.last_scan = maps_[1].nodes.back().id;
  optimised.constraints = {loop.loop};
  optimised.T_map_odom = graph.T_map_odom();
  for (const KnownMap& map : maps_)
    for (const SubmapClosed& closed : map.session.submaps)
      optimised.T_map_keypose.push_back(graph.pose(map.numbers(closed).first_scan));
  optimised.decisions.push_back(decisionOf(graph.loops()[0]));
  SessionsTakenOver first;
  first.T_map_scan = maps_[0].session.graph.T_map_scan;
  {
    SessionWriter writer({both_, "", nullptr, false}, infoOfAll({&maps_[0], &maps_[1]}), 0);
    for (const KnownMap& map : maps_) copyMaps(map, writer);
    writer.add(LogEntry(first));
    writer.add(LogEntry(optimised));
  }
  const Session session = readSession(both_, notices_);
  EXPECT_TRUE(notices_.empty()) << notices_.front();
  for (std::size_t i = 0; i < session.graph.nodes.size(); ++i)
    ASSERT_EQ(session.graph.T_map_scan[i].translation,
              graph.pose(session.graph.nodes[i].id).translation);
}

}  // namespace
}  // namespace revisit_slam
