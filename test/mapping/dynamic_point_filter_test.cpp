// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/dynamic_point_filter.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace revisit_slam {
namespace {

const Eigen::Vector3f kSensor(0.1f, 0.1f, 1.5f);
const Eigen::AlignedBox2f kEverywhere(Eigen::Vector2f(-100, -100), Eigen::Vector2f(100, 100));

/// What is seen from `time` to `last`, from one place.
SeenPoints seen(const Points& points, double time, double last,
                const Eigen::Vector3f& sensor = kSensor) {
  return {{{sensor, time, points.size()}}, points, std::vector<double>(points.size(), last)};
}

Points grid(const Eigen::Vector3f& corner, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  Points points;
  const auto steps = [](const Eigen::Vector3f& side) {
    return static_cast<int>(side.norm() / 0.1f);
  };
  for (int i = 0; i <= steps(a); ++i)
    for (int j = 0; j <= steps(b); ++j)
      points.push_back(corner + 0.1f * static_cast<float>(i) * a.normalized() +
                       0.1f * static_cast<float>(j) * b.normalized());
  return points;
}

const Points kWall = grid({10.05f, -4.0f, 0.05f}, {0, 8, 0}, {0, 0, 5});
const Points kGround = grid({1.05f, -4.0f, 0.05f}, {9, 0, 0}, {0, 8, 0});
const Points kBackground = [] {
  Points both = kWall;
  both.insert(both.end(), kGround.begin(), kGround.end());
  return both;
}();
/// Half way to the wall.
const Points kPerson = grid({5.1f, -0.2f, 0.3f}, {0, 0.4f, 0}, {0, 0, 1.4f});

class DynamicPointFilterTest : public testing::Test {
 protected:
  double shareOf(const Points& points, const std::vector<SeenPoints>& all) const {
    DynamicPointFilter filter(config_, 0.25, box_);
    for (const SeenPoints& some : all) filter.add(some);
    for (const SeenPoints& some : all) filter.lookThrough(some);
    const auto dynamic = std::count_if(points.begin(), points.end(),
                                       [&](const auto& point) { return filter.isDynamic(point); });
    return static_cast<double>(dynamic) / static_cast<double>(points.size());
  }

  DynamicPointConfig config_;
  Eigen::AlignedBox2f box_ = kEverywhere;
  const SeenPoints background_ = seen(kBackground, 0.0f, 10.0f);
};

TEST_F(DynamicPointFilterTest, WhoWalksByIsDynamicAndWhatStandsIsNot) {
  for (const float time : {3.0f, 5.0f}) {
    const std::vector<SeenPoints> all{background_, seen(kPerson, time, time + 0.3f)};
    EXPECT_GT(shareOf(kPerson, all), 0.95);
    EXPECT_EQ(shareOf(kWall, all), 0.0);
    EXPECT_EQ(shareOf(kGround, all), 0.0);
  }
}

TEST_F(DynamicPointFilterTest, LaterRaysCountAsEarlierOnesDo) {
  EXPECT_GT(shareOf(kPerson, {seen(kPerson, 1.0f, 1.3f), seen(kBackground, 2.0f, 10.0f)}), 0.95);
}

TEST_F(DynamicPointFilterTest, WhatIsSeenAsLongAsRaysPassByStands) {
  EXPECT_EQ(shareOf(kPerson, {background_, seen(kPerson, 0.0f, 10.0f)}), 0.0);
  EXPECT_EQ(shareOf(kPerson, {background_, seen(kPerson, 0.4f, 0.4f)}), 0.0);  // within the pause
}

TEST_F(DynamicPointFilterTest, FewOfManyRaysAreNotEnough) {
  const SeenPoints person = seen(kPerson, 5.0f, 9.0f);
  std::vector<SeenPoints> all{background_, person};
  EXPECT_GT(shareOf(kPerson, all), 0.95);
  for (int k = 0; k < 10; ++k)
    all.push_back(
        seen(kBackground, 6.0f, 10.0f, kSensor + Eigen::Vector3f(0.0f, 0.002f * k, 0.0f)));
  EXPECT_LT(shareOf(kPerson, all), 0.05);
  config_.share = 0.0;
  EXPECT_GT(shareOf(kPerson, all), 0.95);
}

TEST_F(DynamicPointFilterTest, WithoutRaysBehindNothingIsKnown) {
  EXPECT_EQ(shareOf(kPerson, {seen(kPerson, 5.0f, 5.3f)}), 0.0);
  config_.rays = 1000;
  EXPECT_EQ(shareOf(kPerson, {background_, seen(kPerson, 5.0f, 5.3f)}), 0.0);
}

TEST_F(DynamicPointFilterTest, NothingIsDynamicOnTheGroundOrOutsideTheBox) {
  const std::vector<SeenPoints> all{background_, seen(kPerson, 5.0f, 5.3f)};
  config_.ground = 0.8;
  const double above = shareOf(kPerson, all);
  EXPECT_GT(above, 0.4);
  EXPECT_LT(above, 0.7);
  config_.ground = 0.15;
  box_ = Eigen::AlignedBox2f(Eigen::Vector2f(6, -4), Eigen::Vector2f(20, 4));
  EXPECT_EQ(shareOf(kPerson, all), 0.0);
  box_ = Eigen::AlignedBox2f(Eigen::Vector2f(4, -1), Eigen::Vector2f(6, 1));  // rays come from afar
  EXPECT_GT(shareOf(kPerson, all), 0.95);
}

}  // namespace
}  // namespace revisit_slam
