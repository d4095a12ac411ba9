// SPDX-License-Identifier: MIT
#include "revisit_slam/types/session_offsets.h"

#include <gtest/gtest.h>

#include "revisit_slam/types/session_groups.h"

namespace revisit_slam {
namespace {

constexpr SessionId kFirst{3}, kSecond{5};

SessionOffsets<ScanId> threeAndTwo() {
  SessionOffsets<ScanId> scans;
  for (std::uint32_t i = 0; i < 3; ++i) scans.append({i, kFirst});
  for (std::uint32_t i = 0; i < 2; ++i) scans.append({i, kSecond});
  return scans;
}

TEST(SessionOffsets, CountSessionAfterSession) {
  const SessionOffsets<ScanId> scans = threeAndTwo();
  EXPECT_EQ(scans.size(), 5u);
  EXPECT_EQ((scans[ScanId{2, kFirst}]), 2u);
  EXPECT_EQ((scans[ScanId{1, kSecond}]), 4u);
  EXPECT_EQ(scans.begin(kSecond), 3u);
  EXPECT_EQ(scans.end(kFirst), 3u);
  EXPECT_EQ(scans.end(kSecond), 5u);
  EXPECT_EQ(scans.sessions(), (std::vector<SessionId>{kFirst, kSecond}));
}

TEST(SessionOffsets, KnowWhatTheyHold) {
  const SessionOffsets<ScanId> scans = threeAndTwo();
  EXPECT_TRUE(scans.contains({2, kFirst}));
  EXPECT_FALSE(scans.contains({3, kFirst}));
  EXPECT_FALSE(scans.contains({0, SessionId{4}}));
  EXPECT_THROW((scans[ScanId{0, SessionId{4}}]), std::out_of_range);
}

TEST(SessionOffsets, RefuseGapsAndSessionsThatAreOver) {
  SessionOffsets<ScanId> scans = threeAndTwo();
  EXPECT_THROW(scans.append({3, kSecond}), std::invalid_argument);
  EXPECT_THROW(scans.append({3, kFirst}), std::invalid_argument);
  EXPECT_THROW(scans.append({1, SessionId{6}}), std::invalid_argument);
  EXPECT_NO_THROW(scans.append({2, kSecond}));
}

LoopEdge loopBetween(std::uint32_t a, std::uint32_t b, LoopState state = LoopState::active) {
  LoopEdge edge;
  edge.loop.target.session = SessionId{a};
  edge.loop.source.session = SessionId{b};
  edge.state = state;
  return edge;
}

TEST(SessionGroups, AreTiedByActiveLoopsAlsoOverOthers) {
  const SessionGroups groups({loopBetween(1, 4), loopBetween(2, 3), loopBetween(2, 4),
                              loopBetween(0, 1, LoopState::rejected)});
  EXPECT_TRUE(groups.areTied(SessionId{3}, SessionId{1}));
  EXPECT_FALSE(groups.areTied(SessionId{0}, SessionId{1}));
  EXPECT_EQ(groups.of(SessionId{3}), SessionId{1});
  EXPECT_EQ(groups.of(SessionId{7}), SessionId{7});
}

}  // namespace
}  // namespace revisit_slam
