// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_summary.h"

#include <gtest/gtest.h>

#include "revisit_slam/session/session_crossing.h"
#include "session/session_fixtures.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

class SessionSummaryTest : public testing::Test {
 protected:
  SessionSummaryTest() { writeStreetSession(folder_.file("a")); }

  SessionSummary summary() {
    std::vector<std::string> notices;
    return summarise(folder_.file("a"), "street", notices);
  }

  TemporaryFolder folder_;
};

TEST_F(SessionSummaryTest, TellsOfEverySubmapWithTheOdometryBetween) {
  const SessionSummary summary = this->summary();
  const StreetDrive& drive = StreetDrive::get();
  EXPECT_EQ(summary.name, "street");
  ASSERT_EQ(summary.submaps.size(), drive.updates.size());
  ASSERT_GT(summary.submaps.size(), 1u);
  for (std::size_t k = 0; k < summary.submaps.size(); ++k) {
    const Submap& submap = *drive.updates[k]->submap;
    EXPECT_EQ(summary.submaps[k].id, submap.id);
    EXPECT_EQ(summary.submaps[k].first_scan, submap.first_scan);
    EXPECT_EQ(summary.submaps[k].travelled_begin, submap.travelled_begin);
    EXPECT_EQ(summary.submaps[k].T_odom_submap.translation, submap.T_odom_submap.translation);
  }
  // Translations of n links of unit information add up to a covariance of n, and levers to more.
  const double links = summary.submaps[1].first_scan.value - summary.submaps[0].first_scan.value;
  const Matrix6 covariance = summary.submaps[1].information.inverse();
  EXPECT_GE(covariance(0, 0), links * 0.999);
  EXPECT_NEAR(covariance(3, 3), links, 1e-6 * links);
}

TEST_F(SessionSummaryTest, IsReadAsItWasWritten) {
  SessionSummary summary = this->summary();
  LoopEdge edge;
  edge.loop = someLoop();
  edge.state = LoopState::rejected;
  edge.weight = 0.5;
  summary.loops.push_back(edge);
  StoredLocalMap place;
  place.features.keypoints = {{3, -4, 0.5f}};
  place.features.descriptors = {{1, 2, 3, 4}};
  place.pixel = 0.5;
  summary.places = {place, place};
  const std::string bytes = encodeSummary(summary);
  const SessionSummary read = readSummary(folder_.with("a.rss", bytes));
  EXPECT_EQ(encodeSummary(read), bytes);
  EXPECT_EQ(read.name, "street");
  EXPECT_EQ(read.loops.at(0).state, LoopState::rejected);
  ASSERT_EQ(read.places.size(), 2u);
  EXPECT_EQ(read.places[1].features.descriptors, place.features.descriptors);
  summary.loops[0].loop.target.value = 1u << 30;
  EXPECT_THROW(readSummary(folder_.with("loop.rss", encodeSummary(summary))), std::runtime_error);
  EXPECT_THROW(readSummary(folder_.with("cut.rss", bytes.substr(0, bytes.size() - 9))),
               std::runtime_error);
}

TEST_F(SessionSummaryTest, WhatIsNoSessionIsNamed) {
  std::vector<std::string> notices;
  try {
    summarise(folder_.file("nothing"), "x", notices);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), "nothing' cannot be used"));
  }
}

TEST_F(SessionSummaryTest, ACrossingIsReadAsItWasWritten) {
  const SessionCrossing crossing{
      "b", "a", {someLoop(), someLoop()}, {{"accepted", 2}, {"fitness", 7}}};
  const std::string bytes = encodeCrossing(crossing);
  const SessionCrossing read = readCrossing(folder_.with("b--a.rsc", bytes));
  EXPECT_EQ(encodeCrossing(read), bytes);
  EXPECT_EQ(read.source, "b");
  EXPECT_EQ(read.loops.size(), 2u);
  EXPECT_EQ(read.loops[1].constraint.T_from_to.translation,
            someLoop().constraint.T_from_to.translation);
  EXPECT_EQ(read.outcomes, crossing.outcomes);
}

}  // namespace
}  // namespace revisit_slam
