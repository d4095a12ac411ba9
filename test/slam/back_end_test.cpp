// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/back_end.h"

#include <gtest/gtest.h>

#include "revisit_slam/io/trajectory.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

constexpr SessionId kFirst{7}, kSecond{8};

/// A drive along x, a metre a scan.
GraphNode node(std::uint32_t number, SessionId session = kFirst) {
  const Pose T_odom_base{Eigen::Quaterniond::Identity(), {1.0 * number, 0, 0}};
  return {{number, session}, Stamp::fromSeconds(100.0 + number), T_odom_base, Matrix6::Identity()};
}

/// Scan `to` is where scan `from` is.
LoopClosures closure(std::uint32_t from, std::uint32_t to, std::uint32_t request,
                     SessionId session = kFirst) {
  LoopConstraint loop;
  loop.constraint.from = {from, session};
  loop.constraint.to = {to, session};
  LoopClosures closures;
  closures.map = {1, session};
  closures.last_scan = {to, session};
  closures.request = request;
  closures.constraints = {loop};
  return closures;
}

class BackEndTest : public testing::Test {
 protected:
  void drive(std::uint32_t from, std::uint32_t to, SessionId session = kFirst) {
    for (std::uint32_t i = from; i < to; ++i)
      ASSERT_NE(back_end_.add(node(i, session)), ScanOrder::missed) << i;
  }

  std::vector<MapCorrectionPtr> corrections_;
  SlamConfig config_;
  BackEnd back_end_{
      config_, [this](const MapCorrectionPtr& correction) { corrections_.push_back(correction); }};
};

TEST_F(BackEndTest, closuresWaitForTheirScansAndAreAnswered) {
  drive(0, 10);
  back_end_.add(closure(0, 19, 3));
  EXPECT_TRUE(corrections_.empty());
  drive(10, 19);
  EXPECT_TRUE(corrections_.empty());
  drive(19, 25);
  ASSERT_EQ(corrections_.size(), 1u);
  const MapCorrection& correction = *corrections_.front();
  EXPECT_EQ(correction.request, 3u);
  EXPECT_EQ(correction.session, kFirst);
  EXPECT_EQ(correction.version, 1u);
  ASSERT_EQ(correction.T_map_scan.size(), 20u);  // up to the closures' last scan, whatever has come
  EXPECT_LT(correction.T_map_scan.back().translation.norm(), 10.0);
}

TEST_F(BackEndTest, theResultDoesNotDependOnWhenScansCame) {
  BackEnd early(config_, [](const MapCorrectionPtr&) {});
  for (std::uint32_t i = 0; i < 30; ++i) early.add(node(i));
  early.add(closure(0, 19, 1));
  drive(0, 5);
  back_end_.add(closure(0, 19, 1));
  drive(5, 30);
  for (std::uint32_t i = 0; i < 30; ++i)
    EXPECT_EQ(early.session()->graph().pose({i, kFirst}).translation,
              back_end_.session()->graph().pose({i, kFirst}).translation);
}

TEST_F(BackEndTest, closuresWithoutConstraintsCorrectNothing) {
  drive(0, 20);
  LoopClosures none = closure(0, 19, 0);
  none.constraints.clear();
  back_end_.add(none);
  EXPECT_TRUE(corrections_.empty());
}

TEST_F(BackEndTest, aNewSessionBeginsWithScanZeroAndTheOneBeforeIsFinished) {
  drive(0, 20);
  drive(0, 5, kSecond);
  EXPECT_EQ(back_end_.session()->id(), kSecond);
  EXPECT_EQ(back_end_.sessions().size(), 2u);
  back_end_.add(closure(0, 19, 1));  // late, of the first
  ASSERT_EQ(corrections_.size(), 1u);
  EXPECT_EQ(corrections_.front()->session, kFirst);
  std::string answer = "none";
  back_end_.add(MapsClosed{kFirst, 20, 0},
                [&](GraphSession*, const std::string& problem) { answer = problem; });
  EXPECT_EQ(answer, "");
  EXPECT_EQ(back_end_.sessions(), std::vector<GraphSession*>{back_end_.session()});
  back_end_.add(
      closure(0, 19, 2));  // it has ended: an answer all the same, as somebody waits for it
  ASSERT_EQ(corrections_.size(), 2u);
  EXPECT_EQ(corrections_.back()->version, 0u);
  EXPECT_EQ(corrections_.back()->request, 2u);
}

/// There is no memory for its first session, for example.
TEST_F(BackEndTest, scansOfASessionThatCouldNotBeginAreOfNoUse) {
  bool fails = true;
  BackEnd back_end(
      config_, [](const MapCorrectionPtr&) {},
      [&fails](SessionId, Stamp) {
        if (fails) throw std::bad_alloc();
        return SessionTarget{};
      });
  EXPECT_THROW(back_end.add(node(0)), std::bad_alloc);
  EXPECT_EQ(back_end.add(node(1)), ScanOrder::missed);
  EXPECT_EQ(back_end.session(), nullptr);
  fails = false;
  EXPECT_EQ(back_end.add(node(0, kSecond)), ScanOrder::first);
  EXPECT_EQ(back_end.add(node(1, kSecond)), ScanOrder::next);
}

TEST_F(BackEndTest, finishingWhenASessionHasBegunDoesNotEndTheOneBefore) {
  drive(0, 20);
  drive(0, 5, kSecond);
  back_end_.add(MapsClosed{kFirst, 20, 4}, [](GraphSession*, const std::string&) {});
  back_end_.add(closure(0, 19, 1));
  ASSERT_EQ(corrections_.size(), 1u);
  EXPECT_EQ(corrections_.front()->version, 1u);
}

TEST_F(BackEndTest, whereFilesCannotBeWrittenTheGraphGoesOnAndSaysSo) {
  config_.live.folder = "/proc/nowhere";
  BackEnd back_end(config_, [](const MapCorrectionPtr&) {});
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_NE(back_end.add(node(i)), ScanOrder::missed);
  EXPECT_EQ(back_end.session()->graph().size(), 5u);
  EXPECT_THROW(back_end.session()->saveOwn(), std::runtime_error);
  EXPECT_NE(back_end.session()->problem().find("/proc/nowhere"), std::string::npos);
}

TEST_F(BackEndTest, aBaseThatRestsAddsNothing) {
  drive(0, 5);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(back_end_.add(node(4)), ScanOrder::repeated);
  EXPECT_EQ(back_end_.session()->graph().size(), 5u);
  EXPECT_EQ(back_end_.add(node(5)), ScanOrder::next);
}

TEST_F(BackEndTest, scansAfterAGapAreOfNoUse) {
  drive(0, 5);
  EXPECT_EQ(back_end_.add(node(7)), ScanOrder::missed);
  EXPECT_EQ(back_end_.session()->graph().size(), 5u);
  EXPECT_EQ(back_end_.add(node(5)), ScanOrder::next);
}

TEST_F(BackEndTest, finishingWaitsForTheScansAndSaysWhatIsWrong) {
  std::string answer = "none";
  const auto keep = [&](GraphSession*, const std::string& problem) { answer = problem; };
  back_end_.add(MapsClosed{kFirst, 10, 1}, keep);
  EXPECT_EQ(answer, "there is nothing to finish");
  answer = "none";
  drive(0, 5);
  back_end_.add(MapsClosed{kFirst, 10, 2}, keep);
  EXPECT_EQ(answer, "none");
  drive(5, 10);
  EXPECT_EQ(answer, "");
}

TEST_F(BackEndTest, aSessionWithAFolderIsOnDiskWhenItIsSaved) {
  const TemporaryFolder folder;
  config_.live.folder = folder.file("drives");
  BackEnd back_end(config_, [](const MapCorrectionPtr&) {});
  for (std::uint32_t i = 0; i < 12; ++i) back_end.add(node(i));
  const std::string drive = back_end.session()->folder();
  back_end.add(MapsClosed{kFirst, 12, 1}, [](GraphSession* session, const std::string& problem) {
    EXPECT_EQ(problem, "");
    ASSERT_NE(session, nullptr);
    session->saveOwn();
  });
  EXPECT_EQ(readTum(drive + "/trajectory.tum").size(), 12u);
}

}  // namespace
}  // namespace revisit_slam
