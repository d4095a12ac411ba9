// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/density_image.h"

#include <gtest/gtest.h>

#include <limits>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

Points column(float x, float y, int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.emplace_back(x, y, 0.5f * static_cast<float>(i));
  return points;
}

Points operator+(Points a, const Points& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(DensityImage, HasItsOriginAtTheLeastPixel) {
  const Points points = column(-3.2f, 1.1f, 21) + column(4.9f, -0.1f, 11) + column(0.0f, 0.0f, 1);
  const DensityImage image = densityImage(points, {}, {});
  EXPECT_EQ(image.origin, Pixel(-7, -1));
  EXPECT_EQ(image.width, 9 - -7 + 1);
  EXPECT_EQ(image.height, 2 - -1 + 1);
  EXPECT_EQ(image.at(0, 3), 255);   // (-3.5 … -3.0, 1.0 … 1.5)
  EXPECT_EQ(image.at(16, 0), 127);  // (4.5 … 5.0, -0.5 … 0.0): 10 of 20 above the least
  EXPECT_EQ(image.at(7, 1), 0) << "bare ground";
}

TEST(DensityImage, DropsSmallDensities) {
  const Points points = column(0.2f, 0.2f, 101) + column(5.2f, 0.2f, 6) + column(9.2f, 0.2f, 7);
  const DensityImage image = densityImage(points, {}, {});
  EXPECT_EQ(image.at(10, 0), 0) << "5 %";
  EXPECT_EQ(image.at(18, 0), 15) << "6 %";
}

TEST(DensityImage, IsOfTheLevelFrame) {
  const Pose T_level_local{expSO3({0, 0, M_PI / 2}), {10.1, 0, 0}};
  const DensityImage image = densityImage(column(2.2f, 0.0f, 5), T_level_local, {});
  EXPECT_EQ(image.origin, Pixel(20, 4));
}

TEST(DensityImage, LeavesOutWhatIsFarOrNoNumber) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Points odd{{nan, 0, 0}, {1e30f, 0, 0}, {401, 0, 0}};
  EXPECT_EQ(densityImage(odd, {}, {}).width, 0);
  EXPECT_EQ(densityImage({}, {}, {}).height, 0);
  const DensityImage image = densityImage(odd + column(1.2f, 0.2f, 2), {}, {});
  EXPECT_EQ(image.width, 1);
  EXPECT_EQ(image.at(0, 0), 255);
}

}  // namespace
}  // namespace revisit_slam
