// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/loop_closing.h"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

#include "support/street_revisit.h"

namespace revisit_slam {
namespace {

class LoopClosingTest : public testing::Test {
 protected:
  LoopClosingTest() {
    config_.loops.recognition.min_inliers = 10000;
    // On its way elsewhere the drive jumps by a kilometre.
    config_.retroactive.low_drift_window = 5000.0;
  }

  LoopClosing::Outputs outputs() {
    LoopClosing::Outputs outputs;
    outputs.search = [](const LoopSearchResult&) {};
    outputs.closures = [this](const LoopClosures& closures) { closures_.push_back(closures); };
    outputs.closed = [this](const MapsClosed& closed) { closed_.push_back(closed); };
    outputs.problem = [](const std::string& problem) { FAIL() << problem; };
    return outputs;
  }

  static MapCorrectionPtr answer(const LoopClosures& closures, LoopState state) {
    auto correction = std::make_shared<MapCorrection>();
    correction->version = 1;
    correction->request = closures.request;
    for (const LoopConstraint& loop : closures.constraints) {
      LoopEdge edge;
      edge.loop = loop;
      edge.state = state;
      correction->loops.push_back(edge);
    }
    return correction;
  }

  const std::vector<LocalMapPtr> maps_ = streetRevisit();
  SlamConfig config_;
  std::vector<LoopClosures> closures_;
  std::vector<MapsClosed> closed_;
};

TEST_F(LoopClosingTest, nothingIsBegunBeforeTheGraphHasAnswered) {
  LoopClosing closing(config_, outputs());
  for (const LocalMapPtr& map : maps_) closing.add(map);
  closing.finish({{}, 0, 7});
  ASSERT_FALSE(closures_.empty());
  ASSERT_FALSE(closures_.back().constraints.empty());
  EXPECT_EQ(closures_.back().origin, LoopOrigin::retroactive);
  EXPECT_GT(closures_.back().request, 0u);
  EXPECT_EQ(closing.waiting(), 1u);
  EXPECT_TRUE(closed_.empty());
  closing.correct(answer(closures_.back(), LoopState::active));
  ASSERT_EQ(closed_.size(), 1u);
  EXPECT_EQ(closed_.front().request, 7u);
  EXPECT_TRUE(closing.isIdle());
}

/// Five passages of a place, of which the graph takes all loops.
TEST_F(LoopClosingTest, eachSearchAtTheEndTakesTwiceAsManyPairs) {
  config_.retroactive.max_pairs = 1;
  LoopClosing closing(config_, outputs());
  std::vector<LoopConstraint> taken;
  const auto answer_all = [&] {
    while (!closing.isIdle()) {
      LoopClosures so_far = closures_.back();
      taken.insert(taken.end(), so_far.constraints.begin(), so_far.constraints.end());
      so_far.constraints = taken;
      closing.correct(answer(so_far, LoopState::active));
    }
  };
  for (const LocalMapPtr& map : streetPassages(5)) {
    closing.add(map);
    answer_all();
  }
  const std::size_t before = closures_.size();
  closing.finish({{}, 0, 7});
  answer_all();
  ASSERT_EQ(closed_.size(), 1u);
  std::vector<std::size_t> pairs;  // of each search
  for (std::size_t i = before; i < closures_.size(); ++i) {
    std::set<LocalMapPair> of_search;
    for (const LoopConstraint& loop : closures_[i].constraints)
      of_search.insert({loop.source_map, loop.target_map});
    pairs.push_back(of_search.size());
  }
  ASSERT_FALSE(pairs.empty());
  EXPECT_EQ(pairs.front(), 1u);
  EXPECT_LT(pairs.size(), std::accumulate(pairs.begin(), pairs.end(), std::size_t{0}));
}

TEST_F(LoopClosingTest, anotherCorrectionIsNoAnswer) {
  LoopClosing closing(config_, outputs());
  for (const LocalMapPtr& map : maps_) closing.add(map);
  closing.finish({{}, 0, 7});
  auto another = std::make_shared<MapCorrection>();  // a loop was disabled, say
  closing.correct(another);
  EXPECT_TRUE(closed_.empty());
}

TEST_F(LoopClosingTest, withoutAGraphItGoesOn) {
  LoopClosing closing(config_, outputs());
  for (const LocalMapPtr& map : maps_) closing.add(map);
  closing.finish({{}, 0, 7});
  closing.giveUpWaiting();
  EXPECT_EQ(closed_.size(), 1u);
  EXPECT_TRUE(closing.isIdle());
}

TEST_F(LoopClosingTest, aGraphThatDoesNotKnowTheSessionIsAnAnswer) {
  LoopClosing closing(config_, outputs());
  for (const LocalMapPtr& map : maps_) closing.add(map);
  closing.finish({{}, 0, 7});
  auto unknown = std::make_shared<MapCorrection>();
  unknown->request = closures_.back().request;
  closing.correct(unknown);
  EXPECT_EQ(closed_.size(), 1u);
}

TEST_F(LoopClosingTest, whatASearchThrowsIsReportedAndTheRestFollows) {
  LoopClosing::Outputs throwing = outputs();
  std::vector<std::string> problems;
  throwing.problem = [&](const std::string& problem) { problems.push_back(problem); };
  throwing.search = [](const LoopSearchResult&) { throw std::runtime_error("cannot draw"); };
  LoopClosing closing(config_, throwing);
  for (const LocalMapPtr& map : maps_) closing.add(map);
  closing.finish({{}, 0, 7});
  closing.giveUpWaiting();
  EXPECT_EQ(closed_.size(), 1u);
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems.front(), "cannot draw");
}

/// Others keep a map until it has been reported. The library lacks a submap of the last one.
TEST_F(LoopClosingTest, aMapWhoseSearchThrowsIsReportedToo) {
  LoopClosing::Outputs throwing = outputs();
  std::vector<std::string> problems;
  throwing.problem = [&](const std::string& problem) { problems.push_back(problem); };
  const auto library = std::make_shared<SubmapLibrary>(0);
  library->add(maps_.back()->submaps.front(), nullptr);
  ASSERT_GT(maps_.back()->submaps.size(), 1u);
  LoopClosing closing(config_, throwing, library);
  for (const LocalMapPtr& map : maps_) {
    closing.add(map);
    closing.giveUpWaiting();
  }
  EXPECT_FALSE(problems.empty());
  std::set<LocalMapId> reported;
  for (const LoopClosures& closures : closures_) reported.insert(closures.map);
  EXPECT_EQ(reported.size(), maps_.size());
}

TEST_F(LoopClosingTest, everyMapIsReportedWithoutLoopsToo) {
  config_.loops.enabled = false;
  LoopClosing closing(config_, outputs());
  for (const LocalMapPtr& map : maps_) closing.add(map);
  std::size_t by_appearance = 0;
  for (const LoopClosures& closures : closures_) {
    EXPECT_TRUE(closures.constraints.empty());
    EXPECT_EQ(closures.request, 0u);
    by_appearance += closures.origin == LoopOrigin::appearance ? 1 : 0;
  }
  EXPECT_EQ(by_appearance, maps_.size());
  EXPECT_TRUE(closing.isIdle());
}

/// The graph may have positions of GNSS for any map, and is asked after each.
TEST_F(LoopClosingTest, withGnssEveryMapWaitsForTheGraph) {
  config_.loops.enabled = false;
  config_.gnss.topic = "/fix";
  LoopClosing closing(config_, outputs());
  for (const LocalMapPtr& map : maps_) closing.add(map);
  closing.finish({{}, 0, 7});
  for (std::size_t answered = 0; closed_.empty() && answered < 1000; ++answered) {
    ASSERT_EQ(closures_.size(), answered + 1);
    ASSERT_EQ(closures_.back().request, answered + 1);
    closing.correct(unchangedMap({}, closures_.back().request));
  }
  EXPECT_EQ(closed_.size(), 1u);
  EXPECT_TRUE(closing.isIdle());
  EXPECT_GE(closures_.size(), maps_.size());
}

}  // namespace
}  // namespace revisit_slam
