// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/place_features.h"

#include <gtest/gtest.h>

#include "place_town.h"
#include "revisit_slam/loops/place_recognition.h"

namespace revisit_slam {
namespace {

TEST(PlaceFeatures, AreBoundedAndLieInTheImage) {
  const PlaceView view = viewPlace(Town(1).mapAt(0, poseInTown(0, 0, 0)), {});
  EXPECT_GT(view.features.size(), 50u);
  EXPECT_LE(view.features.size(), 500u);
  EXPECT_EQ(view.features.keypoints.size(), view.features.size());
  EXPECT_LE(view.features.bytes(), 25000u);
  for (const Keypoint& keypoint : view.features.keypoints) {
    const Pixel p = Pixel(keypoint.i, keypoint.j) - view.image.origin;
    EXPECT_TRUE(p.x() >= 0 && p.x() < view.image.width && p.y() >= 0 && p.y() < view.image.height);
  }
}

/// Pillars that are all the same, as under a bridge.
TEST(PlaceFeatures, ThatRepeatAreDropped) {
  Points pillars;
  for (float x = -80; x < 80; x += 8)
    for (const float y : {-4.0f, 4.0f})
      for (float z = 0; z < 6; z += 0.5f) pillars.emplace_back(x + 0.25f, y + 0.25f, z);
  for (const float side : {-40.25f, 40.25f})
    pillars.emplace_back(0.25f, side, 0.0f);  // wide enough
  const DensityImage image = densityImage(pillars, {}, {});
  PlaceFeaturesConfig keep_all;
  keep_all.self_similarity = 0;
  keep_all.fast_threshold = 10;
  PlaceFeaturesConfig prune = keep_all;
  prune.self_similarity = 35;
  EXPECT_LE(extractPlaceFeatures(image, prune).size(), 4u) << "the ends of the rows may differ";
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
