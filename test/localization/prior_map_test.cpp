// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/prior_map.h"

#include <gtest/gtest.h>

#include "session/session_fixtures.h"
#include "street_map.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

class PriorMapTest : public testing::Test {
 protected:
  PriorMapTest() { writeStreetSession(path_); }

  PriorMapPtr load() {
    notices_.clear();
    return loadPriorMap(path_, {}, kNoRoom, notices_);
  }
  void storePlace(double pixel) {
    StoredLocalMap place;
    for (const MapUpdatePtr& update : StreetDrive::get().updates)
      place.submaps.push_back(update->submap->id);
    place.pixel = pixel;
    place.features.keypoints.resize(2);
    place.features.descriptors.resize(2);
    std::ofstream(localMapFile(path_, place.id), std::ios::binary) << encodeLocalMap(place);
  }

  static constexpr std::size_t kNoRoom = 0;
  TemporaryFolder folder_;
  std::string path_ = folder_.file("session");
  std::vector<std::string> notices_;
};

TEST_F(PriorMapTest, HasTheSubmapsWhereTheSessionLeftThem) {
  storePlace(0.5);
  const PriorMapPtr map = load();
  EXPECT_TRUE(notices_.empty()) << notices_.front();
  ASSERT_EQ(map->submaps.size(), StreetDrive::get().updates.size());
  const Submap& last = *StreetDrive::get().updates.back()->submap;
  const PlacedSubmap whole = map->whole(map->submaps.back());
  EXPECT_EQ(whole.submap->points, last.points);
  EXPECT_EQ(whole.submap->normals, last.normals);
  EXPECT_EQ(whole.T_common_submap.translation, last.T_odom_submap.translation);
  EXPECT_EQ(map->submaps.back().T_common_submap.translation, last.T_odom_submap.translation);
  EXPECT_EQ(map->places.size(), 1u);
}

TEST_F(PriorMapTest, WhatIsMissingOrDoesNotCompareIsNamed) {
  storePlace(0.25);
  std::filesystem::remove(submapFile(path_, SubmapId{1}));
  const PriorMapPtr map = load();
  EXPECT_EQ(map->submaps.size(), StreetDrive::get().updates.size() - 1);
  EXPECT_TRUE(map->places.empty());
  ASSERT_EQ(notices_.size(), 2u);
  EXPECT_TRUE(contains(notices_[0], "without submap 1"));
  EXPECT_TRUE(contains(notices_[1], "image/resolution"));
}

TEST_F(PriorMapTest, PointsAreReadWhenTheyAreNeeded) {
  const PriorMapPtr map = load();
  EXPECT_EQ(map->library->points(SubmapId{1}),
            StreetDrive::get().updates[1]->submap->points.size());
  EXPECT_EQ(map->library->bytes(), 0u);
  for (const PlacedSubmap& placed : map->submaps) EXPECT_TRUE(placed.submap->points.empty());
  std::filesystem::remove(submapFile(path_, SubmapId{1}));
  EXPECT_NO_THROW(map->whole(map->submaps[0]));
  EXPECT_THROW(map->whole(map->submaps[1]), std::runtime_error);
}

TEST_F(PriorMapTest, WithoutAnySubmapItIsRefused) {
  std::filesystem::remove_all(path_ + "/submaps");
  EXPECT_THROW(load(), std::runtime_error);
  EXPECT_THROW(loadPriorMap(folder_.file("nowhere"), {}, kNoRoom, notices_), std::runtime_error);
}

TEST(PriorMap, APoseLiesOnTheGround) {
  PriorMap map;
  const double slope = 0.1;  // the way climbs along x
  for (double x = 0.0; x < 50.0; x += 1.0)
    map.T_map_scan.push_back({expSO3({0, -std::atan(slope), 0}), {x, 0.0, slope * x}});
  const Pose T = map.onGround(10.3, 2.0, M_PI / 2);
  EXPECT_NEAR(T.translation.z(), 1.03, 1e-6);
  const Eigen::Vector3d forward = T.rotation * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(forward.y(), 1.0, 1e-6);
  EXPECT_NEAR(std::abs((T.rotation * Eigen::Vector3d::UnitY()).z()), std::sin(std::atan(slope)),
              1e-6);
  EXPECT_NEAR(map.distanceTo({10.0, 3.0, 1.0}), 3.0, 1e-9);
}

TEST(PriorMap, AStartIsThreeOrSixNumbers) {
  EXPECT_FALSE(startPose("", *streetMap()));
  EXPECT_NEAR(startPose("110 0 0", *streetMap())->translation.z(), 1.5, 1e-6);
  EXPECT_NEAR(startPose(" 1 2 3 0 0 0.5", *streetMap())->angle(), 0.5, 1e-9);
  for (const char* wrong : {"1 2", "1 2 x", "1 2 3 4", "here"})
    EXPECT_THROW(startPose(wrong, *streetMap()), ParameterError) << wrong;
}

}  // namespace
}  // namespace revisit_slam
