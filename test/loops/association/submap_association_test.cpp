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

/// For submaps without points.
AssociationConfig whateverTheySee() {
  AssociationConfig config;
  config.min_overlap = 0.0;
  return config;
}

const std::vector<PlacedSubmap> kTargets{placed(0, 0), placed(25, 0), placed(50, 0)};

TEST(SubmapAssociation, TakesTheNearestTargetOfEachSource) {
  const auto pairs = associate({placed(48, 3), placed(2, 3)}, kTargets, whateverTheySee());
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].source, 0u);
  EXPECT_EQ(pairs[0].target, 2u);
  EXPECT_NEAR(pairs[0].hausdorff, std::hypot(2, 3), 1e-12);
  EXPECT_EQ(pairs[1].target, 0u);
}

TEST(SubmapAssociation, OppositeDirectionsAssociate) {
  const auto pairs = associate({placed(50, 4, M_PI)}, kTargets, whateverTheySee());
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].target, 1u);
  EXPECT_NEAR(pairs[0].hausdorff, 4.0, 1e-9);
}

/// Submaps of 25 m side by side, `apart` metres; from the end of one to the start of the other the
/// drive took `travelled` metres.
bool areCompared(double travelled, double apart, double min_detour) {
  AssociationConfig config = whateverTheySee();
  config.min_detour = min_detour;
  PlacedSubmap later = placed(0, apart);
  auto submap = std::make_shared<Submap>(*later.submap);
  submap->travelled_begin = 25.0 + travelled;
  submap->travelled_end = 50.0 + travelled;
  later.submap = submap;
  auto earlier = std::make_shared<Submap>(*kTargets[0].submap);
  earlier->travelled_end = 25.0;
  return !associate({later}, {{earlier, Pose::identity()}}, config).empty();
}

TEST(SubmapAssociation, NeighboursAreToldByTravelledDistanceOverDisplacement) {
  EXPECT_TRUE(areCompared(66.0, 5.0, 3.0));  // 3 * (5 m + 25 m) from middle to middle
  EXPECT_FALSE(areCompared(64.0, 5.0, 3.0));
  EXPECT_FALSE(areCompared(66.0, 10.0, 3.0));
  EXPECT_TRUE(areCompared(0.0, 5.0, 0.0));
}

TEST(SubmapAssociation, OfOneLocalMapOnlyEarlierSubmapsAreTargets) {
  AssociationConfig config = whateverTheySee();
  config.min_detour = 3.0;
  std::vector<PlacedSubmap> submaps;
  for (int i = 0; i < 4; ++i) {
    submaps.push_back(placed(0, i));
    auto submap = std::make_shared<Submap>(*submaps.back().submap);
    submap->travelled_begin = 60.0 * i;
    submap->travelled_end = submap->travelled_begin + 25.0;
    submaps.back().submap = submap;
  }
  for (const SubmapPair& pair : associate(submaps, submaps, config))
    EXPECT_GE(pair.source, pair.target + 2);
  EXPECT_EQ(associate(submaps, submaps, config).size(), 2u);
}

TEST(SubmapAssociation, NothingBeyondTheThresholds) {
  EXPECT_TRUE(associate({placed(0, 101)}, kTargets, whateverTheySee()).empty());
  AssociationConfig config = whateverTheySee();
  config.max_gap = 30.0;
  EXPECT_TRUE(associate({placed(0, 31)}, kTargets, config).empty());
  EXPECT_EQ(associate({placed(0, 29)}, kTargets, config).size(), 1u);
  EXPECT_TRUE(associate({placed(0, 0)}, {}, whateverTheySee()).empty());
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
  const auto back = associate({lookingAhead(65, 0, M_PI)}, targets, whateverTheySee());
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(back[0].target, 0u);
  EXPECT_GT(back[0].overlap, 0.8);
  EXPECT_NEAR(back[0].hausdorff, 40.0, 1e-9);
  EXPECT_EQ(associate({lookingAhead(50, 2)}, targets, whateverTheySee())[0].target, 2u);
}

TEST(SubmapAssociation, NotWhereTheyShareTooLittle) {
  const std::vector<PlacedSubmap> target{lookingAhead(0, 0)};
  EXPECT_EQ(associate({lookingAhead(15, 0)}, target, {}).size(), 1u);
  EXPECT_TRUE(associate({lookingAhead(30, 0)}, target, {}).empty());
}

TEST(SubmapAssociation, AsInThePaperTheNearestTargetWhateverItSaw) {
  const std::vector<PlacedSubmap> targets{lookingAhead(0, 0), lookingAhead(25, 0),
                                          lookingAhead(50, 0)};
  AssociationConfig config = whateverTheySee();
  config.target = "nearest";
  const auto back = associate({lookingAhead(65, 0, M_PI)}, targets, config);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(back[0].target, 2u);  // 65 to 40 is nearest to 50 to 75
}

const Eigen::Quaterniond kUpright = Eigen::Quaterniond::Identity();

TEST(SubmapAssociation, ComparesTrajectoriesAsTheGraphHasThemWhereItIsAsked) {
  PlacedSubmap bent = placed(0, 0);
  for (int i = 0; i <= 25; ++i) bent.T_common_scan.push_back({kUpright, {1.0 * i, 0.2 * i, 0.0}});
  const auto pairs = associate({bent}, {placed(0, 0)}, whateverTheySee());
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
