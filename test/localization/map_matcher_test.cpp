// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/map_matcher.h"

#include <gtest/gtest.h>

#include "revisit_slam/localization/localization_config.h"
#include "street_map.h"

namespace revisit_slam {
namespace {

class MapMatcherTest : public testing::Test {
 protected:
  MapMatcherTest() : matcher_(streetMap(), {}, {}, LocalizationConfig().min_overlap) {
    SyntheticStreet street(5, 2);
    open_ = std::make_shared<const Submap>(submapOf(street, drive(15, 35)));
  }

  Pose truth() const { return T_map_street() * open_->T_odom_submap; }
  static Pose off(const Pose& T, double metres, double degrees) {
    return T * Pose{expSO3({0, 0, degrees * M_PI / 180.0}), {metres, 0.0, 0.0}};
  }

  MapMatcher matcher_;
  SubmapPtr open_;
};

TEST_F(MapMatcherTest, FindsTheLastMetresInTheMap) {
  const MapMatch match = matcher_.track(open_, off(truth(), 0.1, 0.5), 5.0);
  ASSERT_TRUE(match.accepted) << match.reason;
  EXPECT_LT((match.T_map_open.translation - truth().translation).norm(), 0.03);
  EXPECT_GT(match.overlap, 0.3);
  EXPECT_GT(match.information(0, 0), 1.0);
}

TEST_F(MapMatcherTest, AGuessThatIsFarOffHasToBeConfirmed) {
  const Pose guess = off(truth(), 1.5, 8.0);
  EXPECT_FALSE(matcher_.track(open_, guess, 5.0).accepted);
  const MapMatch match = matcher_.relocate(open_, guess);
  ASSERT_TRUE(match.accepted) << match.reason;
  EXPECT_LT((match.T_map_open.translation - truth().translation).norm(), 0.03);
}

TEST_F(MapMatcherTest, AnotherStreetIsNotTheMap) {
  SyntheticStreet other(6, 2);
  const auto open = std::make_shared<const Submap>(submapOf(other, drive(15, 35)));
  EXPECT_FALSE(matcher_.relocate(open, truth()).accepted);
}

/// Its folder is gone: that is no place off the map.
TEST_F(MapMatcherTest, AMapThatCannotBeReadIsTheReason) {
  auto gone = std::make_shared<PriorMap>(*streetMap());
  gone->library = std::make_shared<SubmapLibrary>(0);
  for (const PlacedSubmap& placed : gone->submaps) {
    gone->library->add(streetMap()->whole(placed).submap, nullptr);
    gone->library->noteStored(placed.submap->id,
                              []() -> Submap { throw std::runtime_error("no such file"); });
  }
  MapMatcher matcher(gone, {}, {}, LocalizationConfig().min_overlap);
  const MapMatch match = matcher.track(open_, truth(), 5.0);
  EXPECT_FALSE(match.accepted);
  EXPECT_EQ(match.reason, "no such file");
}

TEST_F(MapMatcherTest, FarFromTheWayThereIsNoMap) {
  EXPECT_EQ(matcher_.track(open_, off(truth(), 1000.0, 0.0), 5.0).reason, "off the map");
}

TEST_F(MapMatcherTest, WhereTheOdometryWasLostTheRegistrationMayEndFartherOff) {
  const Pose guess = off(truth(), 0.7, 1.5);
  EXPECT_FALSE(matcher_.track(open_, guess, 5.0).accepted);
  Matrix6 covariance = Matrix6::Zero();
  covariance.diagonal() << 0.25, 0.25, 0.25, 1e-3, 1e-3, 1e-3;
  const MapMatch match = matcher_.track(open_, guess, 5.0, covariance);
  ASSERT_TRUE(match.accepted) << match.reason;
  EXPECT_LT((match.T_map_open.translation - truth().translation).norm(), 0.03);
}

}  // namespace
}  // namespace revisit_slam
