// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/association/submap_association.h"

#include <gtest/gtest.h>

#include <memory>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

/// A submap of 25 m along x, in steps of 1 m.
PlacedSubmap placed(double x, double y, double yaw = 0.0) {
  auto submap = std::make_shared<Submap>();
  submap->T_submap_scan.resize(26);
  for (int i = 0; i <= 25; ++i) submap->T_submap_scan[i].translation.x() = i;
  return {submap, {expSO3({0, 0, yaw}), {x, y, 0}}};
}

const std::vector<PlacedSubmap> kTargets{placed(0, 0), placed(25, 0), placed(50, 0)};

TEST(SubmapAssociation, TakesTheNearestTargetOfEachSource) {
  const auto pairs = associate({placed(48, 3), placed(2, 3)}, kTargets, {});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].source, 0u);
  EXPECT_EQ(pairs[0].target, 2u);
  EXPECT_NEAR(pairs[0].hausdorff, std::hypot(2, 3), 1e-12);
  EXPECT_EQ(pairs[1].target, 0u);
}

TEST(SubmapAssociation, OppositeDirectionsAssociate) {
  const auto pairs = associate({placed(50, 4, M_PI)}, kTargets, {});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].target, 1u);
  EXPECT_NEAR(pairs[0].hausdorff, 4.0, 1e-9);
}

TEST(SubmapAssociation, NotWithLessTravelledBetweenThanAsked) {
  auto later = std::make_shared<Submap>(*kTargets[0].submap);
  later->travelled_begin = 130.0;
  AssociationConfig config;
  config.min_travelled = 100.0;
  const auto ending = [](double travelled_end) {
    auto submap = std::make_shared<Submap>(*kTargets[0].submap);
    submap->travelled_end = travelled_end;
    return std::vector<PlacedSubmap>{{submap, Pose::identity()}};
  };
  const std::vector<PlacedSubmap> sources{{later, Pose::identity()}};
  EXPECT_EQ(associate(sources, ending(30.0), config).size(), 1u);
  EXPECT_TRUE(associate(sources, ending(30.5), config).empty());
}

TEST(SubmapAssociation, NothingBeyondTheThresholds) {
  EXPECT_TRUE(associate({placed(0, 101)}, kTargets, {}).empty());
  AssociationConfig config;
  config.max_gap = 30.0;
  EXPECT_TRUE(associate({placed(0, 31)}, kTargets, config).empty());
  EXPECT_EQ(associate({placed(0, 29)}, kTargets, config).size(), 1u);
  EXPECT_TRUE(associate({placed(0, 0)}, {}, {}).empty());
}

/// The same with walls on both sides from 20 m to 45 m ahead: what a sensor sees that looks ahead.
PlacedSubmap lookingAhead(double x, double y, double yaw = 0.0) {
  const PlacedSubmap plain = placed(x, y, yaw);
  auto submap = std::make_shared<Submap>(*plain.submap);
  for (float ahead = 20; ahead < 45; ahead += 0.5f)
    for (float up = 0; up < 5; up += 0.5f)
      for (const float aside : {-10.0f, 10.0f}) submap->points.emplace_back(ahead, aside, up);
  return {submap, plain.T_common_submap};
}

TEST(SubmapAssociation, TakesTheTargetThatSawTheSameFromElsewhere) {
  const std::vector<PlacedSubmap> targets{lookingAhead(0, 0), lookingAhead(25, 0),
                                          lookingAhead(50, 0)};
  const auto back = associate({lookingAhead(65, 0, M_PI)}, targets, {});
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(back[0].target, 0u);
  EXPECT_GT(back[0].overlap, 0.8);
  EXPECT_NEAR(back[0].hausdorff, 40.0, 1e-9);
  EXPECT_EQ(associate({lookingAhead(50, 2)}, targets, {})[0].target, 2u);
}

TEST(SubmapAssociation, AsInThePaperTheNearestTargetWhateverItSaw) {
  const std::vector<PlacedSubmap> targets{lookingAhead(0, 0), lookingAhead(25, 0),
                                          lookingAhead(50, 0)};
  AssociationConfig config;
  config.target = "nearest";
  const auto back = associate({lookingAhead(65, 0, M_PI)}, targets, config);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(back[0].target, 2u);  // 65 to 40 is nearest to 50 to 75
}

const Eigen::Quaterniond kUpright = Eigen::Quaterniond::Identity();

TEST(SubmapAssociation, ComparesTrajectoriesAsTheGraphHasThemWhereItIsAsked) {
  PlacedSubmap bent = placed(0, 0);
  for (int i = 0; i <= 25; ++i) bent.T_common_scan.push_back({kUpright, {1.0 * i, 0.2 * i, 0.0}});
  const auto pairs = associate({bent}, {placed(0, 0)}, {});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_NEAR(pairs[0].hausdorff, 5.0, 1e-9);
}

TEST(SubmapAssociation, MovesTrajectoriesAlongWithTheirSubmaps) {
  PlacedSubmap bent = placed(0, 0);
  for (int i = 0; i <= 25; ++i) bent.T_common_scan.push_back({kUpright, {1.0 * i, 0.2 * i, 0.0}});
  const Pose T_new_common{expSO3({0, 0, 0.5 * M_PI}), {10, 0, 0}};
  for (const PlacedSubmap& here : moved({bent, placed(0, 0)}, T_new_common)) {
    EXPECT_NEAR((pathOf(here)[0] - Eigen::Vector3d(10, 0, 0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(pathOf(here)[25].y(), 25.0, 1e-12);
  }
}

}  // namespace
}  // namespace revisit_slam
