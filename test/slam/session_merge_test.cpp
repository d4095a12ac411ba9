// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/session_merge.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <utility>

#include "revisit_slam/localization/prior_map.h"
#include "revisit_slam/session/map_export.h"
#include "support/session_logs.h"
#include "support/simulated_slam.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

/// A session, and where each of its scans was.
struct Driven {
  std::string folder;
  std::vector<Pose> truth;
};

/// Sessions of a simulated town: the first part of a way, on another day the way back from its end,
/// and a drive through another town.
class SessionMergeTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    simulation::VisitConfig back;
    back.number = 1;
    back.reversed = true;
    const InformedDrive out = simulate(3, {}), other = simulate(8, {});
    returned_ = simulate(3, back);
    part_ = out.scans.size() * 2 / 3;
    drives_.push_back(map("a", out, part_));
    drives_.push_back(map("b", returned_, part_));
    drives_.push_back(map("other", other, part_ / 2));
    const std::vector<KnownMap> both = read({0, 1});
    const SessionMerge merge(SlamConfig{}, both, [](const LoopSearchResult&) {});
    merge.write(merged());
    merged_poses_ = merge.graph().poses();
  }
  static void TearDownTestSuite() { folder_.reset(); }
  /// The first two drives.
  static std::string merged() { return folder_->file("merged"); }

  static InformedDrive simulate(unsigned seed, const simulation::VisitConfig& visit) {
    return simulateInformedDrive("tour", 600.0, "spinning-64", 256, seed, SlamConfig{}, visit);
  }

  /// As the drive that these scans are of would have left it.
  static Driven map(const std::string& name, const InformedDrive& drive, std::size_t scans,
                    const KnownMapPtr& prior = {}, const SlamConfig& config = {}) {
    Driven driven{folder_->file(name), drive.truth};
    SlamRecorder recorder;
    InlineExecutor executor;
    const SessionTargets targets = [&](SessionId, Stamp) {
      return SessionTarget{driven.folder, "simulated", nullptr, false};
    };
    Slam slam(config, recorder, executor, targets);
    for (std::size_t i = 0; i < scans; ++i) {
      InformedScan informed = drive.scans[i];
      auto scan = std::make_shared<RegisteredScan>(*informed.scan);
      if (prior) scan->id.session = nextSession(prior->session.info);
      if (i == 0) scan->goes_on_from = prior;
      informed.scan = std::move(scan);
      slam.insert(informed);
    }
    slam.finish();
    slam.session()->writeRest();
    return driven;
  }

  static std::vector<KnownMap> read(const std::vector<std::size_t>& which) {
    std::vector<KnownMap> maps;
    std::vector<std::string> notices;
    for (std::uint32_t i = 0; i < which.size(); ++i)
      maps.push_back(readKnownMap(drives_[which[i]].folder, SessionId{i},
                                  SlamConfig{}.loops.recognition, notices));
    EXPECT_TRUE(notices.empty()) << notices.front();
    return maps;
  }

  /// RMSE of positions after one rigid alignment of both, m.
  static double error(const std::vector<GraphNode>& nodes, const std::vector<Pose>& T_map_scan,
                      const std::vector<Driven>& drives) {
    TrajectoryMatch match;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Stamp stamp{static_cast<std::int64_t>(i)};
      const ScanId id = nodes[i].id;
      match.estimate.push_back({stamp, T_map_scan[i]});
      match.reference.push_back({stamp, drives.at(id.session.value).truth.at(id.value)});
    }
    return absoluteError(match).rmse;
  }

  static std::map<std::string, std::string> filesOf(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().filename() != "lock")
        files[std::filesystem::relative(entry.path(), folder).string()] =
            textOf(entry.path().string());
    return files;
  }

  static std::unique_ptr<TemporaryFolder> folder_;
  static InformedDrive returned_;
  static std::size_t part_;  // scans
  static std::vector<Driven> drives_;
  static std::vector<Pose> merged_poses_;
};

std::unique_ptr<TemporaryFolder> SessionMergeTest::folder_;
InformedDrive SessionMergeTest::returned_;
std::size_t SessionMergeTest::part_;
std::vector<Driven> SessionMergeTest::drives_;
std::vector<Pose> SessionMergeTest::merged_poses_;

TEST_F(SessionMergeTest, DrivesThroughOnePlaceAreJoinedAndOthersLeftOut) {
  const std::vector<KnownMap> maps = read({0, 1, 2});
  const auto before = filesOf(drives_[0].folder);
  const SessionMerge merge(SlamConfig{}, maps, [](const LoopSearchResult&) {});
  EXPECT_EQ(merge.joined(), (std::vector<std::size_t>{0, 1}));
  EXPECT_FALSE(merge.isJoined(2));
  EXPECT_EQ(filesOf(drives_[0].folder), before);
}

TEST_F(SessionMergeTest, TheResultIsASessionOfBoth) {
  std::vector<std::string> notices;
  const Session session = readSession(merged(), notices);
  EXPECT_TRUE(notices.empty()) << notices.front();
  EXPECT_LT(error(session.graph.nodes, session.graph.T_map_scan, drives_), 0.3);
  EXPECT_EQ(sessionsOf(session), (std::vector<SessionId>{SessionId{0}, SessionId{1}}));
  ASSERT_EQ(session.info.joined.size(), 1u);
  EXPECT_EQ(session.info.joined[0].from, drives_[1].folder);
  ASSERT_EQ(session.graph.nodes.size(), merged_poses_.size());
  for (std::size_t i = 0; i < merged_poses_.size(); ++i)
    ASSERT_EQ(session.graph.T_map_scan[i].translation, merged_poses_[i].translation);
  ExportConfig graph_and_cloud;
  graph_and_cloud.occupancy = false;
  const std::string folder = folder_->file("export");
  EXPECT_TRUE(exportSession(session, folder, graph_and_cloud).empty());
  for (const char* name :
       {"map.pcd", "trajectory_0.tum", "trajectory_1.tum", "submaps/1_000000.pcd"})
    EXPECT_TRUE(std::filesystem::exists(folder + "/" + name)) << name;
  const PriorMapPtr prior =
      loadPriorMap(merged(), SlamConfig{}.loops.recognition, 1'000'000, notices);
  EXPECT_EQ(prior->submaps.size(), session.submaps.size());
  EXPECT_TRUE(notices.empty());
}

TEST_F(SessionMergeTest, TheSameBytesForAnyNumberOfThreads) {
  SlamConfig config;
  config.background.threads = config.backend.solver.threads = 2;
  const std::vector<KnownMap> maps = read({0, 1});
  const std::string folder = folder_->file("two_threads");
  SessionMerge(config, maps, [](const LoopSearchResult&) {}).write(folder);
  auto files = filesOf(folder), expected = filesOf(merged());
  for (auto* either : {&files, &expected}) either->erase("session.yaml");  // tells the threads
  EXPECT_GT(files.size(), 10u);
  EXPECT_EQ(files, expected);
}

/// What is merged can be merged again: its sessions stay together.
TEST_F(SessionMergeTest, AMergedSessionIsMergedFurther) {
  std::vector<std::string> notices;
  const PlaceRecognitionConfig recognition = SlamConfig{}.loops.recognition;
  std::vector<KnownMap> maps;
  maps.push_back(readKnownMap(drives_[2].folder, SessionId{0}, recognition, notices));
  maps.push_back(readKnownMap(merged(), SessionId{1}, recognition, notices));
  EXPECT_EQ(maps[1].numbers.size(), 2u);
  const SessionMerge merge(SlamConfig{}, maps, [](const LoopSearchResult&) {});
  EXPECT_EQ(merge.joined(), std::vector<std::size_t>{0});
  EXPECT_EQ(merge.graph().loops().size(), maps[0].loops.size() + maps[1].loops.size());
  EXPECT_TRUE(SessionGroups(merge.graph().loops()).areTied(SessionId{1}, SessionId{2}));
}

TEST_F(SessionMergeTest, ADriveThatGoesOnFromAMapJoinsIt) {
  std::vector<std::string> notices;
  const auto prior = std::make_shared<const KnownMap>(
      readKnownMap(drives_[0].folder, {}, SlamConfig{}.loops.recognition, notices));
  const auto before = filesOf(drives_[0].folder);
  const Driven extended = map("extended", returned_, part_, prior);
  EXPECT_EQ(filesOf(drives_[0].folder), before);
  const Session session = readSession(extended.folder, notices);
  EXPECT_TRUE(notices.empty()) << notices.front();
  EXPECT_TRUE(session.info.closed);
  EXPECT_EQ(sessionsOf(session), (std::vector<SessionId>{SessionId{0}, SessionId{1}}));
  EXPECT_EQ(sessionsOf(tiedTo(SessionId{0}, session)), sessionsOf(session));
  for (const SubmapClosed& closed : prior->session.submaps)  // with the same ids
    EXPECT_EQ(textOf(submapFile(extended.folder, closed.id)),
              textOf(submapFile(drives_[0].folder, closed.id)));
  EXPECT_LT(error(session.graph.nodes, session.graph.T_map_scan, {drives_[0], extended}), 0.3);
}

TEST_F(SessionMergeTest, ADriveThatGoesOnFromAFrozenMapMovesNothingOfIt) {
  std::vector<std::string> notices;
  const auto prior = std::make_shared<const KnownMap>(
      readKnownMap(drives_[0].folder, {}, SlamConfig{}.loops.recognition, notices));
  SlamConfig config;
  config.backend.freeze_map = true;
  const Driven extended = map("frozen", returned_, part_, prior, config);
  const SessionGraph written = readSession(extended.folder, notices).graph;
  forgetTrajectory(extended.folder);
  const SessionGraph graph = readSession(extended.folder, notices).graph;
  EXPECT_TRUE(notices.empty()) << notices.front();
  for (std::size_t i = 0; i < written.T_map_scan.size(); ++i)
    EXPECT_EQ(graph.T_map_scan[i].matrix(), written.T_map_scan[i].matrix()) << i;
  EXPECT_TRUE(SessionGroups(graph.loops).areTied(SessionId{0}, SessionId{1}));
  const std::vector<Pose>& known = prior->session.graph.T_map_scan;
  for (std::size_t i = 0; i < known.size(); ++i)
    EXPECT_EQ(graph.T_map_scan[i].matrix(), known[i].matrix()) << i;
  EXPECT_LT(error(graph.nodes, graph.T_map_scan, {drives_[0], extended}), 0.3);
}

TEST_F(SessionMergeTest, ADriveElsewhereKeepsAMapOfItsOwn) {
  std::vector<std::string> notices;
  const auto prior = std::make_shared<const KnownMap>(
      readKnownMap(drives_[2].folder, {}, SlamConfig{}.loops.recognition, notices));
  const Driven extended = map("apart", returned_, part_, prior);
  const Session session = readSession(extended.folder, notices);
  EXPECT_EQ(sessionsOf(tiedTo(SessionId{0}, session)), std::vector<SessionId>{SessionId{0}});
  const std::vector<Pose> T_map_scan = tiedTo(SessionId{1}, session).graph.T_map_scan;
  const std::vector<Pose> alone = readSession(drives_[1].folder, notices).graph.T_map_scan;
  ASSERT_EQ(T_map_scan.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
    ASSERT_LT((T_map_scan[i].translation - alone[i].translation).norm(), 0.01) << i;
}

/// It may be tied to a drive that is not tied to the map either.
TEST_F(SessionMergeTest, ADriveIsInTheMapWhereLoopsTieItToTheFirstSession) {
  const auto tie = [](std::uint32_t source, std::uint32_t target) {
    LoopEdge edge;
    edge.loop.source.session = SessionId{source};
    edge.loop.target.session = SessionId{target};
    return edge;
  };
  MapCorrection correction;
  correction.session = SessionId{2};
  correction.begin = {{SessionId{0}, 0}, {SessionId{1}, 100}, {SessionId{2}, 200}};
  EXPECT_FALSE(correction.places(SessionId{2}));
  correction.loops = {tie(2, 1)};
  EXPECT_FALSE(correction.places(SessionId{2}));
  correction.loops.push_back(tie(1, 0));
  EXPECT_TRUE(correction.places(SessionId{2}));
}

}  // namespace
}  // namespace revisit_slam
