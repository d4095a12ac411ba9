// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/graph_session.h"

#include <gtest/gtest.h>

#include <new>
#include <thread>
#include <utility>

#include "revisit_slam/io/pcd.h"
#include "session/session_fixtures.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

class GraphSessionTest : public testing::Test {
 protected:
  GraphSession session(const std::string& folder) {
    return {SessionId{},
            config_,
            drive_.nodes.front().stamp,
            {folder, "", nullptr, false},
            [](const MapCorrectionPtr&) {}};
  }

  /// Scans, with the maps that end with them.
  void play(GraphSession& session, std::size_t first_map, std::size_t end_map) const {
    for (std::size_t i = first_map; i < end_map; ++i) {
      for (const GraphNode& node : drive_.nodesOf(*drive_.updates[i]->submap)) session.add(node);
      session.add(drive_.updates[i]);
    }
  }

  LoopClosures closures(std::uint32_t request) const {
    LoopClosures closures;
    closures.map = drive_.updates.back()->submap->local_map;
    closures.last_scan = drive_.updates.back()->submap->lastScan();
    closures.request = request;
    closures.constraints = {someLoop()};
    return closures;
  }

  /// As soon as so many loops are on disk.
  static Session readWhenItHas(std::size_t loops, const std::string& folder) {
    for (;; std::this_thread::yield()) try {
        std::vector<std::string> notices;
        const Session read = readSession(folder, notices);
        if (read.graph.loops.size() < loops || !notices.empty()) continue;
        return read;
      } catch (const std::runtime_error&) {
        // not begun
      }
  }

  static void expectEqual(const SessionGraph& a, const SessionGraph& b) {
    ASSERT_EQ(a.T_map_scan.size(), b.T_map_scan.size());
    for (std::size_t i = 0; i < a.T_map_scan.size(); ++i) {
      EXPECT_EQ(a.T_map_scan[i].translation, b.T_map_scan[i].translation) << i;
      EXPECT_EQ(a.T_map_scan[i].rotation.coeffs(), b.T_map_scan[i].rotation.coeffs()) << i;
    }
    ASSERT_EQ(a.loops.size(), b.loops.size());
    for (std::size_t i = 0; i < a.loops.size(); ++i) {
      EXPECT_EQ(a.loops[i].state, b.loops[i].state);
      EXPECT_EQ(a.loops[i].chi2_after, b.loops[i].chi2_after);
    }
  }

  const StreetDrive& drive_ = StreetDrive::get();
  SlamConfig config_;
  TemporaryFolder folder_;
};

TEST_F(GraphSessionTest, TheFolderOfAKilledProcessSaysWhatTheGraphSaid) {
  GraphSession session = this->session(folder_.file("session"));
  play(session, 0, drive_.updates.size());
  session.add(closures(1));
  session.disable(LoopId{0});
  LoopClosures again = closures(2);
  again.constraints.front().constraint.T_from_to.translation.y() -= 0.1;
  session.add(again);
  ASSERT_GT(
      (session.graph().pose({7}).translation - drive_.nodes[7].T_odom_base.translation).norm(),
      1e-3);
  EXPECT_THROW(session.save("relative"), std::runtime_error);
  const std::string copy = session.save(folder_.file("copy"));

  for (const std::string& folder : {folder_.file("session"), copy}) {
    const Session read = readWhenItHas(2, folder);
    EXPECT_EQ(read.submaps.size(), drive_.updates.size());
    expectEqual(read.graph, session.snapshot().graph);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_.file("session/map.pcd")));
  session.saveOwn();
  for (const char* name : {"map.pcd", "map.bt", "trajectory.tum", "pose_graph.g2o",
                           "loop_closures.csv", "submaps/submaps.csv", "submaps/000001.pcd"})
    EXPECT_TRUE(textOf(folder_.file("session/") + name) == textOf(copy + "/" + name)) << name;
}

/// The map manager searches for nothing until it is answered.
TEST_F(GraphSessionTest, AnswersWhateverFails) {
  std::vector<MapCorrectionPtr> answers;
  bool fails = true;
  GraphSession session({}, config_, drive_.nodes.front().stamp, {},
                       [&](const MapCorrectionPtr& correction) {
                         if (std::exchange(fails, false)) throw std::bad_alloc();
                         answers.push_back(correction);
                       });
  play(session, 0, drive_.updates.size());
  EXPECT_THROW(session.add(closures(7)), std::bad_alloc);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers.front()->request, 7u);
  session.add(closures(8));
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers.back()->request, 8u);
}

TEST_F(GraphSessionTest, SavingTwiceMakesTwoFolders) {
  GraphSession session = this->session("");
  play(session, 0, 2);
  EXPECT_EQ(session.save(folder_.file("saved")), folder_.file("saved"));
  EXPECT_EQ(session.save(folder_.file("saved")), folder_.file("saved_2"));
  EXPECT_EQ(textOf(folder_.file("saved/map.pcd")), textOf(folder_.file("saved_2/map.pcd")));
  for (const char* nowhere : {"", "relative", "../outside", "/proc/nowhere"})
    EXPECT_THROW(session.save(nowhere), std::runtime_error) << nowhere;
}

TEST_F(GraphSessionTest, AFolderThatWasRemovedIsWrittenAnew) {
  const std::string folder = folder_.file("session");
  GraphSession session = this->session(folder);
  play(session, 0, 1);
  session.saveOwn();
  std::filesystem::remove_all(folder);
  play(session, 1, 2);
  EXPECT_THROW(session.saveOwn(), std::runtime_error);
  EXPECT_TRUE(contains(session.problem(), "No such file"));
  for (std::uint32_t i = static_cast<std::uint32_t>(session.graph().size()); i < 20; ++i) {
    GraphNode node = drive_.nodes.back();  // stands still
    node.id.value = i;
    session.add(node);
  }
  session.add(drive_.updates.at(2));
  session.saveOwn();
  EXPECT_EQ(session.problem(), "");
  std::vector<std::string> notices;
  EXPECT_EQ(readSession(folder, notices).submaps.size(), 3u);
  EXPECT_EQ(readPcdPoints(folder + "/submaps/000001.pcd"), drive_.updates[1]->detail_submap);
}

TEST_F(GraphSessionTest, TheEndUnaskedKeepsScansOfTheOpenSubmap) {
  const std::string folder = folder_.file("session");
  {
    GraphSession session = this->session(folder);
    play(session, 0, 1);
    session.add(drive_.nodes.at(session.graph().size()));
    session.writeRest();
  }
  std::vector<std::string> notices;
  const Session read = readSession(folder, notices);
  EXPECT_FALSE(read.info.closed);
  EXPECT_EQ(read.graph.nodes.size(), read.submaps.back().last_scan.value + 2u);
}

}  // namespace
}  // namespace revisit_slam
