// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/loop_detector.h"

#include <gtest/gtest.h>

#include "support/street_revisit.h"

namespace revisit_slam {
namespace {

/// Two local maps of one place, which appearance does not recognise.
class LoopDetectorTest : public testing::Test {
 protected:
  LoopDetectorTest() : detector_(loops(), {}, {}) {
    for (const LocalMapPtr& map : streetRevisit()) detector_.searchByAppearance(map);
  }

  static LoopsConfig loops() {
    LoopsConfig config;
    config.recognition.min_inliers = 10000;
    return config;
  }

  /// The graph's answer to these loops.
  void answer(const std::vector<LoopConstraint>& loops, LoopState state) {
    auto correction = std::make_shared<MapCorrection>();
    for (const LoopConstraint& loop : loops) {
      LoopEdge edge;
      edge.loop = loop;
      edge.state = state;
      correction->loops.push_back(edge);
    }
    detector_.correct(correction);
  }

  LoopDetector detector_;
};

TEST_F(LoopDetectorTest, aPairThatTheGraphHasTakenIsNotSearchedAgain) {
  const auto found = detector_.searchRetroactively().accepted();
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().source_map, LocalMapId{2});
  EXPECT_EQ(found.front().target_map, LocalMapId{0});
  answer(found, LoopState::active);
  EXPECT_TRUE(detector_.newestIsClosed());
  std::set<LocalMapPair> tried;
  EXPECT_TRUE(detector_.searchUnspent(tried).proposals.empty());
}

TEST_F(LoopDetectorTest, whatTheGraphRejectsIsNoClosure) {
  const auto found = detector_.searchRetroactively().accepted();
  ASSERT_FALSE(found.empty());
  answer(found, LoopState::rejected);
  EXPECT_FALSE(detector_.newestIsClosed());
  EXPECT_FALSE(detector_.hasClosedLoops());
}

TEST_F(LoopDetectorTest, aSearchThatIsNotSpentLeavesTheWindowToTheNextClosure) {
  std::set<LocalMapPair> tried;
  const auto early = detector_.searchUnspent(tried).accepted();
  ASSERT_FALSE(early.empty());
  EXPECT_TRUE(detector_.searchUnspent(tried).proposals.empty());  // all were tried by now
  answer(early, LoopState::rejected);
  EXPECT_EQ(detector_.searchRetroactively().accepted().size(), early.size());
}

TEST_F(LoopDetectorTest, theWindowIsSpentByASearchAfterAClosure) {
  EXPECT_FALSE(detector_.searchRetroactively().proposals.empty());
  EXPECT_TRUE(detector_.searchRetroactively().proposals.empty());
}

TEST_F(LoopDetectorTest, aLoopThatTheUserDisabledIsNotFoundAgain) {
  const auto found = detector_.searchRetroactively().accepted();
  answer(found, LoopState::disabled);
  std::set<LocalMapPair> tried;
  EXPECT_TRUE(detector_.searchUnspent(tried).proposals.empty());
}

TEST_F(LoopDetectorTest, asInThePaperTheEndOfTheDriveStartsNoSearch) {
  RetroactiveConfig retroactive;
  retroactive.search_at_end = false;
  LoopDetector detector(loops(), retroactive, {});
  for (const LocalMapPtr& map : streetRevisit()) detector.searchByAppearance(map);
  std::set<LocalMapPair> tried;
  EXPECT_TRUE(detector.searchUnspent(tried).proposals.empty());
  EXPECT_FALSE(detector.searchRetroactively().proposals.empty());
}

}  // namespace
}  // namespace revisit_slam
