// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/loop_detector.h"

#include <gtest/gtest.h>

#include "support/synthetic_street.h"

namespace revisit_slam {
namespace {

/// Out along a street, 300 m elsewhere, and back along it: two local maps of one place, which
/// appearance does not recognise.
class LoopDetectorTest : public testing::Test {
 protected:
  LoopDetectorTest() : detector_(loops(), {}, {}) {
    MapHierarchy hierarchy{MappingConfig{}};
    SyntheticStreet out(5, 1), back(5, 2);
    std::uint32_t id = 0;
    const auto insert = [&](const Pose& T, SyntheticStreet& street) {
      hierarchy.insert({id++}, {}, T, street.scan(T));
    };
    for (const Pose& T : drive(0, 50)) insert(T, out);
    maps_.push_back(hierarchy.closeAll().local_map);
    for (double y = 5.0; y <= 150.0; y += 5.0) insert(poseAt(1050, y), out);
    maps_.push_back(hierarchy.closeAll().local_map);
    for (const Pose& T : drive(52, 2, 2.0)) insert(T, back);
    maps_.push_back(hierarchy.closeAll().local_map);
    for (const LocalMapPtr& map : maps_) detector_.searchByAppearance(map);
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

  std::vector<LocalMapPtr> maps_;
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

}  // namespace
}  // namespace revisit_slam
