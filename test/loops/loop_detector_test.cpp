// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/loop_detector.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <stdexcept>

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
  TriedPairs tried;
  EXPECT_TRUE(detector_.searchUnspent(tried).proposals.empty());
}

/// Whether a pair of maps is compared of which each has one loop: with the same third one, or with
/// others.
bool isCompared(int max_partners, bool is_common) {
  RetroactiveConfig retroactive;
  retroactive.max_partners = max_partners;
  LoopsConfig loops;
  loops.recognition.min_inliers = 10000;
  LoopDetector detector(loops, retroactive, {});
  const auto maps = streetRevisit();
  for (const LocalMapPtr& map : maps) detector.searchByAppearance(map);
  auto correction = std::make_shared<MapCorrection>();
  for (const std::size_t of : {0, 2}) {
    LoopEdge edge;
    edge.loop.source_map = maps[of]->id;
    edge.loop.target_map = maps[1]->id;
    if (!is_common) edge.loop.target_map.value += 10 + static_cast<std::uint32_t>(of);
    edge.loop.source = maps[of]->submaps.front()->id;
    edge.loop.target = maps[1]->submaps.front()->id;
    edge.state = LoopState::active;
    correction->loops.push_back(edge);
  }
  detector.correct(correction);
  return !detector.searchRetroactively().proposals.empty();
}

TEST(LoopDetector, MapsThatLoopsTieToEnoughOthersAndToEachOtherAreNotCompared) {
  EXPECT_FALSE(isCompared(1, true));
  EXPECT_TRUE(isCompared(2, true));
  EXPECT_TRUE(isCompared(1, false)) << "to others, not to each other";
}

/// The retroactive loops of the newest map, where the submaps of these numbers cannot be read.
std::vector<LoopConstraint> foundWithout(const std::set<std::uint32_t>& gone) {
  const auto library = std::make_shared<SubmapLibrary>(0);
  LoopsConfig loops;
  loops.recognition.min_inliers = 10000;
  LoopDetector detector(loops, {}, {}, library);
  for (const LocalMapPtr& map : streetRevisit()) {
    for (const SubmapPtr& submap : map->submaps) {
      library->add(submap, nullptr);
      const bool is_gone = gone.count(submap->id.value) > 0;
      library->noteStored(submap->id, [submap, is_gone] {
        if (is_gone) throw std::runtime_error("gone");
        return *submap;
      });
    }
    detector.searchByAppearance(map);
  }
  return detector.searchRetroactively().accepted();
}

TEST(LoopDetector, ASubmapThatCannotBeReadCostsItsOwnLoopsAlone) {
  const auto targets = [](const std::vector<LoopConstraint>& loops) {
    std::set<std::uint32_t> targets;
    for (const LoopConstraint& loop : loops) targets.insert(loop.target.value);
    return targets;
  };
  EXPECT_EQ(targets(foundWithout({})), (std::set<std::uint32_t>{0, 1}));
  EXPECT_EQ(targets(foundWithout({0})), std::set<std::uint32_t>{1});
  EXPECT_THROW(foundWithout({0, 1}), std::runtime_error);
}

TEST_F(LoopDetectorTest, whatTheGraphRejectsIsNoClosure) {
  const auto found = detector_.searchRetroactively().accepted();
  ASSERT_FALSE(found.empty());
  answer(found, LoopState::rejected);
  EXPECT_FALSE(detector_.newestIsClosed());
  EXPECT_FALSE(detector_.hasClosedLoops());
}

TEST_F(LoopDetectorTest, aSearchThatIsNotSpentLeavesTheWindowToTheNextClosure) {
  TriedPairs tried;
  const auto early = detector_.searchUnspent(tried).accepted();
  ASSERT_FALSE(early.empty());
  EXPECT_TRUE(detector_.searchUnspent(tried).proposals.empty());  // all were tried by now
  answer(early, LoopState::rejected);
  EXPECT_EQ(detector_.searchRetroactively().accepted().size(), early.size());
}

TEST_F(LoopDetectorTest, aPairThatWasTriedIsTriedAgainOnceTheGraphHasMovedIt) {
  TriedPairs tried;
  EXPECT_FALSE(detector_.searchUnspent(tried).proposals.empty());
  detector_.forgetChanged(tried);
  EXPECT_TRUE(detector_.searchUnspent(tried).proposals.empty());
  auto correction = std::make_shared<MapCorrection>();
  for (const LocalMapPtr& map : detector_.maps())
    for (const SubmapPtr& submap : map->submaps)
      for (const Pose& T_submap_scan : submap->T_submap_scan) {
        correction->T_map_scan.push_back(submap->T_odom_submap * T_submap_scan);
        if (map == detector_.maps().back()) correction->T_map_scan.back().translation.y() += 0.5;
      }
  detector_.correct(correction);
  detector_.forgetChanged(tried);
  EXPECT_FALSE(detector_.searchUnspent(tried).proposals.empty());
}

/// Pairs of maps that one search compares among four passages of a place.
std::size_t comparedInABatch(int max_pairs, std::size_t batches, int max_partners) {
  LoopsConfig loops;
  loops.recognition.min_inliers = 10000;
  RetroactiveConfig retroactive;
  retroactive.max_pairs = max_pairs;
  retroactive.max_partners = max_partners;
  LoopDetector detector(loops, retroactive, {});
  for (const LocalMapPtr& map : streetPassages(4)) detector.searchByAppearance(map);
  TriedPairs tried;
  std::set<LocalMapPair> pairs;
  for (const LoopProposal& proposal : detector.searchUnspent(tried, batches).proposals)
    pairs.insert({proposal.loop.source_map, proposal.loop.target_map});
  return pairs.size();
}

TEST(LoopDetector, ALargerBatchTriesMorePairs) {
  EXPECT_EQ(comparedInABatch(1, 1, 10), 1u);
  EXPECT_GE(comparedInABatch(1, 4, 10), 2u);
}

TEST(LoopDetector, WhatABatchItselfTiesWellIsLeft) {
  EXPECT_LT(comparedInABatch(1000, 1, 1), comparedInABatch(1000, 1, 10));
}

TEST_F(LoopDetectorTest, theWindowIsSpentByASearchAfterAClosure) {
  EXPECT_FALSE(detector_.searchRetroactively().proposals.empty());
  EXPECT_TRUE(detector_.searchRetroactively().proposals.empty());
}

TEST_F(LoopDetectorTest, aLoopThatTheUserDisabledIsNotFoundAgain) {
  const auto found = detector_.searchRetroactively().accepted();
  answer(found, LoopState::disabled);
  TriedPairs tried;
  EXPECT_TRUE(detector_.searchUnspent(tried).proposals.empty());
}

TEST_F(LoopDetectorTest, asInThePaperTheEndOfTheDriveStartsNoSearch) {
  RetroactiveConfig retroactive;
  retroactive.search_at_end = false;
  LoopDetector detector(loops(), retroactive, {});
  for (const LocalMapPtr& map : streetRevisit()) detector.searchByAppearance(map);
  TriedPairs tried;
  EXPECT_TRUE(detector.searchUnspent(tried).proposals.empty());
  EXPECT_FALSE(detector.searchRetroactively().proposals.empty());
}

/// As the only one of session 1.
LocalMapPtr inAnotherSession(const LocalMap& map) {
  auto other = std::make_shared<LocalMap>();
  other->id = {0, SessionId{1}};
  const Submap& first = *map.submaps.front();
  for (const SubmapPtr& submap : map.submaps) {
    auto moved = std::make_shared<Submap>(*submap);
    moved->id = {submap->id.value - first.id.value, SessionId{1}};
    moved->local_map = other->id;
    moved->first_scan = {submap->first_scan.value - first.first_scan.value, SessionId{1}};
    other->submaps.push_back(moved);
  }
  return other;
}

/// What was merged before was searched then.
TEST(LoopDetector, SessionsAreSearchedAgainWhenTheyAreJoinedNotWhenTheyWereBefore) {
  const std::vector<LocalMapPtr> maps = streetRevisit();
  const auto apart = std::make_shared<MapCorrection>();
  const auto joined = std::make_shared<MapCorrection>();
  joined->loops.resize(1);
  joined->loops.front().state = LoopState::active;
  joined->loops.front().loop.target_map = {1, SessionId{0}};
  joined->loops.front().loop.source_map = {0, SessionId{1}};
  joined->loops.front().loop.target = maps[1]->submaps.front()->id;
  joined->loops.front().loop.source = {0, SessionId{1}};
  for (const bool before : {true, false}) {
    LoopDetector detector({}, {}, {});
    for (const LocalMapPtr& map : {maps[0], maps[1], inAnotherSession(*maps[2])})
      detector.addSearched(map, {});
    detector.correct(before ? joined : apart);
    detector.correct(joined);
    TriedPairs tried;
    EXPECT_EQ(detector.searchUnspent(tried).proposals.empty(), before);
  }
}

}  // namespace
}  // namespace revisit_slam
