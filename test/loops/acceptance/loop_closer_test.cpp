// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/loop_closer.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "support/synthetic_street.h"

namespace revisit_slam {
namespace {

/// The local map of a drive; ids of scans count from `first_scan`.
LocalMapPtr localMapOf(SyntheticStreet street, const std::vector<Pose>& T_street_scan,
                       unsigned first_scan) {
  MapHierarchy hierarchy{MappingConfig{}};
  for (const Pose& T : T_street_scan) hierarchy.insert({first_scan++}, {}, T, street.scan(T));
  return hierarchy.closeAll().local_map;
}

std::string outcomeOfFirst(const LoopCloser& closer, const std::vector<PlacedSubmap>& sources,
                           const std::vector<PlacedSubmap>& targets, LoopOrigin origin) {
  return closer.close(sources, targets, origin).front().verdict.outcome();
}

class LoopCloserTest : public testing::Test {
 protected:
  std::vector<LoopProposal> close(const LocalMap& source, const Tangent& error) const {
    const Pose guess = boxplus(T_target_source_, error);
    return LoopCloser({}, {}).close(source, *target_, guess, LoopOrigin::appearance);
  }

  const LocalMapPtr target_ = localMapOf(SyntheticStreet(5, 1), drive(0, 50), 0);
  const LocalMapPtr source_ = localMapOf(SyntheticStreet(5, 2), drive(52, 2, 2.0), 100);
  const Pose T_target_source_ = target_->T_odom_local().inverse() * source_->T_odom_local();
  const Tangent error_ = (Tangent() << 0.8, -0.9, 0.1, 0.01, 0, 0.03).finished();
};

TEST_F(LoopCloserTest, ClosesTheLoopOfOppositeDrives) {
  const auto proposals = close(*source_, error_);
  ASSERT_EQ(proposals.size(), source_->submaps.size());
  for (const LoopProposal& proposal : proposals) {
    const LoopConstraint& loop = proposal.loop;
    ASSERT_TRUE(proposal.verdict.isAccepted()) << proposal.verdict.reason();
    const Submap& target = *target_->submaps[loop.target.value];
    const Submap& source = *source_->submaps[loop.source.value];
    EXPECT_EQ(loop.constraint.from, target.first_scan);
    EXPECT_EQ(loop.constraint.to, source.first_scan);
    EXPECT_LT(distanceBetween(loop.constraint.T_from_to,
                              target.T_odom_submap.inverse() * source.T_odom_submap),
              0.03);
    EXPECT_GT(loop.constraint.information(0, 0), 10.0);
    EXPECT_GT(proposal.registered.movedTranslation(), 0.5);
  }
}

TEST_F(LoopCloserTest, RejectsAnotherStreet) {
  const auto elsewhere = localMapOf(SyntheticStreet(9, 2), drive(52, 2, 2.0), 100);
  const auto proposals = close(*elsewhere, error_);
  EXPECT_FALSE(proposals.empty());
  for (const LoopProposal& proposal : proposals) EXPECT_FALSE(proposal.verdict.isAccepted());
}

TEST_F(LoopCloserTest, APairThatNoOtherConfirmsMayTurnLess) {
  const Tangent turned = (Tangent() << 0, 0, 0, 0, 0, 7.0 * M_PI / 180.0).finished();
  auto sources = placeByOdometry(*source_, boxplus(T_target_source_, turned));
  const auto targets = placeByOdometry(*target_, Pose::identity());
  const LoopCloser closer({}, {});
  EXPECT_GE(acceptedOf(closer.close(sources, targets, LoopOrigin::retroactive)).size(), 2u);
  sources.resize(1);
  const auto alone = closer.close(sources, targets, LoopOrigin::retroactive);
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0].verdict.gate, "lone rotation");
  EXPECT_LT(alone[0].registered.movedRotation(), LoopCloserConfig().max_rotation);
}

TEST_F(LoopCloserTest, AloneAndFoundByPlaceOnlyAPairHasToBeMoreCoherent) {
  const std::vector<PlacedSubmap> alone{placeByOdometry(*source_, T_target_source_).front()};
  const auto targets = placeByOdometry(*target_, Pose::identity());
  const LoopOrigin retroactive = LoopOrigin::retroactive;
  LoopCloserConfig config;
  const LoopProposal usual = LoopCloser(config, {}).close(alone, targets, retroactive).front();
  ASSERT_TRUE(usual.verdict.isAccepted()) << usual.verdict.reason();
  config.min_coherence = usual.registered.registration.coherence - 1e-6;
  const LoopCloser strict(config, {});
  EXPECT_EQ(outcomeOfFirst(strict, alone, targets, LoopOrigin::appearance), "accepted");
  EXPECT_EQ(outcomeOfFirst(strict, alone, targets, retroactive), "lone coherence");
}

TEST_F(LoopCloserTest, WhereTheGraphPlacedThemRegistrationsMayNotDifferByDrift) {
  auto sources = placeByOdometry(*source_, T_target_source_);
  const auto targets = placeByOdometry(*target_, Pose::identity());
  sources.front().T_common_submap.translation.x() += 0.6;  // one is pulled along by something else
  const LoopCloser closer({}, {});
  EXPECT_EQ(outcomeOfFirst(closer, sources, targets, LoopOrigin::appearance), "accepted");
  EXPECT_EQ(outcomeOfFirst(closer, sources, targets, LoopOrigin::retroactive), "consistency");
  const std::vector<PlacedSubmap> alone{sources.front()};
  EXPECT_EQ(outcomeOfFirst(closer, alone, targets, LoopOrigin::appearance), "accepted");
  EXPECT_EQ(outcomeOfFirst(closer, alone, targets, LoopOrigin::retroactive), "lone translation");
}

TEST_F(LoopCloserTest, OneOfTwoIsNoMajorityWhereTheOthersWallsDoNotFit) {
  const auto elsewhere = localMapOf(SyntheticStreet(9, 2), drive(52, 2, 2.0), 100);
  const auto targets = placeByOdometry(*target_, Pose::identity());
  const std::vector<PlacedSubmap> right{placeByOdometry(*source_, T_target_source_).front()};
  const std::vector<PlacedSubmap> both{right.front(),
                                       placeByOdometry(*elsewhere, T_target_source_).back()};
  LoopCloserConfig config;
  config.min_fitness = 0.0;  // the other is incoherent, too
  const LoopCloser closer(config, {});
  for (const LoopOrigin origin : {LoopOrigin::appearance, LoopOrigin::retroactive}) {
    const bool graph = origin == LoopOrigin::retroactive;
    EXPECT_EQ(outcomeOfFirst(closer, right, targets, origin), "accepted");
    const auto contested = closer.close(both, targets, origin);
    ASSERT_EQ(contested.size(), 2u);
    EXPECT_EQ(contested[1].verdict.outcome(), "coherence");
    EXPECT_EQ(contested[0].verdict.outcome(), graph ? "consistency" : "accepted");
  }
}

TEST_F(LoopCloserTest, DoesNotDependOnThreads) {
  std::vector<LoopProposal> one, four;
  tbb::task_arena(1).execute([&] { one = close(*source_, error_); });
  tbb::task_arena(4).execute([&] { four = close(*source_, error_); });
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    const Constraint &a = one[i].loop.constraint, &b = four[i].loop.constraint;
    EXPECT_EQ(a.T_from_to.matrix(), b.T_from_to.matrix());
    EXPECT_EQ(a.information, b.information);
  }
}

}  // namespace
}  // namespace revisit_slam
