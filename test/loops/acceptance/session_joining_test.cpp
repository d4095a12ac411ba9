// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/session_joining.h"

#include <gtest/gtest.h>

#include <memory>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

/// Sessions of ten local maps of one scan each, every 50 m along x; each in a map of its own.
class SessionJoiningTest : public testing::Test {
 protected:
  static ScanPoses poses() {
    SessionOffsets<ScanId> scans;
    std::vector<Pose> T_map_scan;
    for (std::uint32_t session = 0; session < 3; ++session)
      for (std::uint32_t i = 0; i < 10; ++i) {
        scans.append({i, SessionId{session}});
        T_map_scan.push_back(placeOf(i));
      }
    return {T_map_scan, scans};
  }
  static Pose placeOf(std::uint32_t number) {
    return {Eigen::Quaterniond::Identity(), {50.0 * number, 0.0, 0.0}};
  }

  /// A loop that says where the second session's map lies in that of the first.
  static LoopProposal loop(LocalMapId target, LocalMapId source, const Pose& T_first_second) {
    LoopProposal proposal;
    LoopConstraint& loop = proposal.loop;
    loop.target_map = target;
    loop.source_map = source;
    loop.target = {target.value, target.session};
    loop.source = {source.value, source.session};
    loop.constraint.from = {target.value, target.session};
    loop.constraint.to = {source.value, source.session};
    const Pose T_target_source =
        placeOf(target.value).inverse() * T_first_second * placeOf(source.value);
    proposal.registered.registration.T_target_source = T_target_source;
    proposal.registered.target = std::make_shared<const Submap>();
    proposal.registered.source = std::make_shared<const Submap>();
    return proposal;
  }
  static LoopProposal loop(std::uint32_t target, std::uint32_t source, const Pose& T) {
    return loop({target, kFirst}, {source, kSecond}, T);
  }

  std::vector<LoopProposal> believed(const SessionGroups& groups = {}) {
    return joining_.takeBelieved(poses(), groups);
  }

  static constexpr SessionId kFirst{0}, kSecond{1}, kThird{2};
  const Pose right_{expSO3({0.0, 0.0, 1.0}), {10.0, 20.0, 0.0}};
  const Pose wrong_{expSO3({0.0, 0.0, -1.0}), {300.0, 20.0, 0.0}};
  SessionJoining joining_{JoiningConfig{}, PairwiseConsistencyConfig{}};
};

TEST_F(SessionJoiningTest, ASinglePlaceIsNotBelieved) {
  const LoopProposal held = joining_.hold(loop(1, 2, right_));
  EXPECT_EQ(held.verdict.outcome(), "joining");
  EXPECT_FALSE(held.verdict.reason().empty());
  joining_.hold(loop(1, 2, right_));  // another pair of submaps of the same local maps
  joining_.hold(loop(1, 7, right_));  // the same place once more
  EXPECT_TRUE(believed().empty());
  EXPECT_EQ(joining_.held(), 3u);
}

TEST_F(SessionJoiningTest, PlacesThatAgreeAreBelievedAndOthersAreNot) {
  joining_.hold(loop(1, 2, right_));
  joining_.hold(loop(8, 3, wrong_));
  joining_.hold(loop(2, 3, right_));
  const std::vector<LoopProposal> loops = believed();
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_TRUE(loops[0].verdict.isAccepted());
  EXPECT_EQ(loops[0].loop.target_map, (LocalMapId{1, kFirst}));
  EXPECT_EQ(loops[1].loop.target_map, (LocalMapId{2, kFirst}));
  EXPECT_EQ(joining_.held(), 0u);
}

TEST_F(SessionJoiningTest, AsManyPlacesThatSayOtherwiseKeepSessionsApart) {
  for (const Pose& T : {right_, wrong_}) {
    joining_.hold(loop(1, 2, T));
    joining_.hold(loop(3, 4, T));
  }
  EXPECT_TRUE(believed().empty());
  joining_.hold(loop(5, 6, right_));
  EXPECT_EQ(believed().size(), 3u);
}

TEST_F(SessionJoiningTest, DriftIsAllowedForByTheWayBetween) {
  Pose drifted = right_;
  drifted.translation.y() += 1.5;
  joining_.hold(loop(1, 1, right_));
  joining_.hold(loop(2, 2, drifted));  // 100 m in both sessions together: 2.3 m
  EXPECT_EQ(believed().size(), 2u);
  drifted.translation.y() += 1.5;
  joining_.hold(loop(1, 1, right_));
  joining_.hold(loop(2, 2, drifted));
  EXPECT_TRUE(believed().empty());
}

/// The third saw one place of each; the first two are tied, and their maps are one.
TEST_F(SessionJoiningTest, SessionsThatAreTiedConfirmEachOther) {
  joining_.hold(loop({1, kFirst}, {2, kThird}, right_));
  joining_.hold(loop({3, kSecond}, {4, kThird}, right_));
  EXPECT_TRUE(believed().empty());
  SessionGroups groups;
  groups.join(kFirst, kSecond);
  EXPECT_EQ(believed(groups).size(), 2u);
}

/// The second is in the map of the third, which is in none with the first: sources and targets
/// change sides.
TEST_F(SessionJoiningTest, ALoopSpeaksInEitherDirection) {
  SessionGroups groups;
  groups.join(kFirst, kThird);
  joining_.hold(loop({1, kFirst}, {2, kSecond}, right_));
  joining_.hold(loop({4, kSecond}, {3, kThird}, right_.inverse()));
  EXPECT_EQ(believed(groups).size(), 2u);
}

/// It may wait for days.
TEST_F(SessionJoiningTest, WhatWaitsKeepsNoPoints) {
  const LoopProposal held = joining_.hold(loop(1, 2, right_));
  EXPECT_TRUE(held.registered.source);  // as is shown
  joining_.hold(loop(2, 3, right_));
  for (const LoopProposal& proposal : believed()) {
    EXPECT_FALSE(proposal.registered.source);
    EXPECT_FALSE(proposal.registered.target);
  }
}

}  // namespace
}  // namespace revisit_slam
