// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_recognition.h"

#include <gtest/gtest.h>

#include <limits>

#include "place_town.h"
#include "support/threads.h"

namespace revisit_slam {
namespace {

PlaceRecognitionConfig withNewest() {
  PlaceRecognitionConfig config;
  config.newest_excluded = 0;
  return config;
}

LocalMap namedMap(unsigned id, Points points = {}) {
  LocalMap map;
  map.id = {id};
  map.points = std::move(points);
  return map;
}

class Revisit : public ::testing::TestWithParam<Eigen::Vector3d> {};

TEST_P(Revisit, IsRecognisedWithItsPose) {
  Town town(1);
  const Pose T_town_target = poseInTown(0, 0, 0.3);
  const Pose T_town_source = poseInTown(GetParam().x(), GetParam().y(), GetParam().z());
  PlaceRecognition recognition(withNewest());
  EXPECT_FALSE(recognition.recognise(Town(2).mapAt(1, poseInTown(0, 0, 0.3))));
  EXPECT_FALSE(recognition.recognise(town.mapAt(2, T_town_target))) << "another town";
  EXPECT_FALSE(recognition.recognise(Town(3).mapAt(3, T_town_source))) << "another town";
  const auto match = recognition.recognise(town.mapAt(4, T_town_source));
  ASSERT_TRUE(match);
  EXPECT_EQ(match->source, LocalMapId{4});
  EXPECT_EQ(match->target, LocalMapId{2});
  EXPECT_GT(match->inliers, 5);
  EXPECT_LT(match->rms, 1.5);
  const Pose error = (T_town_target.inverse() * T_town_source).inverse() * match->T_target_source;
  EXPECT_LT(error.translation.norm(), 1.0);
  EXPECT_LT(error.angle(), 0.02);
}

// x, y [m], heading [rad] in the town
INSTANTIATE_TEST_SUITE_P(Poses, Revisit,
                         ::testing::Values(Eigen::Vector3d(0, 0, 0.3), Eigen::Vector3d(3, 5, 0.35),
                                           Eigen::Vector3d(-4, 2, 0.3 + M_PI),
                                           Eigen::Vector3d(30, 10, -1.2),
                                           Eigen::Vector3d(-20, 40, 2.0)));

TEST(PlaceRecognition, LeavesOutTheNewestMaps) {
  Town town(1);
  const LocalMap map = town.mapAt(0, poseInTown(0, 0, 0));
  PlaceRecognition recognition{PlaceRecognitionConfig()};
  for (unsigned id = 0; id < 6; ++id) {
    const auto match = recognition.recognise(namedMap(id, map.points));
    ASSERT_EQ(match.has_value(), id > 3) << id;
    if (match) {
      EXPECT_EQ(match->target, LocalMapId{0}) << "the first of equally good ones";
    }
  }
  EXPECT_EQ(recognition.candidates().size(), 2u);
}

TEST(PlaceRecognition, LeavesOutNoneFromBeforeTheTrackWasLost) {
  const LocalMap map = Town(1).mapAt(0, poseInTown(0, 0, 0));
  PlaceRecognition recognition{PlaceRecognitionConfig()};
  EXPECT_FALSE(recognition.recognise(map));
  LocalMap after_loss = namedMap(1, map.points);
  after_loss.after_loss = true;
  const auto match = recognition.recognise(after_loss);
  ASSERT_TRUE(match);
  EXPECT_EQ(match->target, LocalMapId{0});
  ASSERT_TRUE(recognition.recognise(namedMap(2, map.points)));
  EXPECT_EQ(recognition.candidates().size(), 1u) << "the map after the loss is one of the newest";
}

TEST(PlaceRecognition, TakesAnyMap) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  PlaceRecognition recognition(withNewest());
  for (const Points& points : {Points{}, Points{{1, 2, 3}}, Points(1000, {nan, nan, nan}),
                               Points(1000, {1e30f, -1e30f, 0}), Points(1000, {1, 1, 1}),
                               RandomNumbers(1).cloud(5000, 2.0)})
    EXPECT_FALSE(recognition.recognise(namedMap(0, points)));
  EXPECT_EQ(recognition.size(), 6u);
  EXPECT_TRUE(recognition.candidates().empty());
}

TEST(PlaceRecognition, DoesNotDependOnTheNumberOfThreads) {
  const auto run = [] {
    Town town(1);
    PlaceRecognition recognition(withNewest());
    for (unsigned id = 0; id < 12; ++id)
      recognition.recognise(town.mapAt(id, poseInTown(3.0 * id, 2.0 * id, 0.5 * id)));
    return recognition.candidates();
  };
  const auto one = onThreads(1, run), four = onThreads(4, run);
  ASSERT_GE(one.size(), 5u);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].target, four[i].target);
    EXPECT_EQ(one[i].inliers, four[i].inliers);
    EXPECT_EQ(one[i].T_target_source.matrix(), four[i].T_target_source.matrix());
    if (i > 0) {
      EXPECT_GE(one[i - 1].inliers, one[i].inliers);
    }
  }
}

TEST(PlaceRecognition, KeepsLittleOfAMap) {
  Town town(1);
  PlaceRecognition recognition{PlaceRecognitionConfig()};
  recognition.recognise(town.mapAt(7, poseInTown(0, 0, 0)));
  EXPECT_LE(recognition.bytes(), 25000u);
  EXPECT_EQ(recognition.lastView().id, LocalMapId{7});
  EXPECT_GT(recognition.lastView().features.size(), 0u);
  EXPECT_GT(recognition.lastView().image.width, 200);
}

}  // namespace
}  // namespace revisit_slam
