// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_features.h"

#include <gtest/gtest.h>

#include "place_town.h"
#include "revisit_slam/loops/recognition/place_recognition.h"

namespace revisit_slam {
namespace {

TEST(PlaceFeatures, AreBoundedAndLieInTheImage) {
  const PlaceView view = viewPlace(Town(1).mapAt(0, poseInTown(0, 0, 0)), {});
  EXPECT_GT(view.features.size(), 50u);
  EXPECT_LE(view.features.size(), 500u);
  EXPECT_EQ(view.features.keypoints.size(), view.features.size());
  for (const Keypoint& keypoint : view.features.keypoints) {
    const Pixel p = Pixel(keypoint.i, keypoint.j) - view.image.origin;
    EXPECT_TRUE(p.x() >= 0 && p.x() < view.image.width && p.y() >= 0 && p.y() < view.image.height);
  }
}

/// A row of ten blocks, 20 m apart, that are copies of each other or not.
DensityImage blocks(bool are_copies) {
  RandomNumbers random(1);
  Points points;
  for (int block = 0; block < 10; ++block) {
    if (are_copies) random = RandomNumbers(1);
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 24; ++j) {
        const double height = random.uniform(0, 1) < 0.3 ? random.uniform(0, 15) : 0.4;
        for (double z = 0; z < height; z += 0.5)
          points.push_back(Eigen::Vector3d(20 * block + 0.5 * i, 0.5 * j, z).cast<float>());
      }
  }
  for (const float side : {-30.0f, 40.0f}) points.emplace_back(0.0f, side, 0.0f);  // wide enough
  return densityImage(points, {}, {});
}

TEST(PlaceFeatures, ThatRepeatAreDropped) {
  EXPECT_GT(extractPlaceFeatures(blocks(false), {}).size(), 10u);
  EXPECT_EQ(extractPlaceFeatures(blocks(true), {}).size(), 0u);
}

TEST(PlaceFeatures, AreNoneWhereThereIsNothing) {
  EXPECT_EQ(extractPlaceFeatures({}, {}).size(), 0u);
  DensityImage blank;
  blank.width = blank.height = 200;
  blank.values.resize(40000);
  EXPECT_EQ(extractPlaceFeatures(blank, {}).size(), 0u);
  blank.width = 40000;
  blank.height = 1;
  EXPECT_EQ(extractPlaceFeatures(blank, {}).size(), 0u);
}

}  // namespace
}  // namespace revisit_slam
