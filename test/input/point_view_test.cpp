// SPDX-License-Identifier: MIT
#include "revisit_slam/input/point_view.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>

namespace revisit_slam {
namespace {

PointView view(std::size_t width, std::size_t height, std::size_t row_step, std::size_t size) {
  PointView view;
  view.width = width;
  view.height = height;
  view.point_step = 12;
  view.row_step = row_step;
  view.size = size;
  view.fields = {{"x", NumberType::float32, 0}, {"z", NumberType::float32, 8}};
  return view;
}

TEST(PointView, layoutsThatFit) {
  EXPECT_EQ(layoutFault(view(10, 1, 120, 120)), "");
  EXPECT_EQ(layoutFault(view(10, 1, 0, 120)), "") << "row_step is not needed for one row";
  EXPECT_EQ(layoutFault(view(10, 3, 128, 384)), "");
  EXPECT_EQ(layoutFault(view(10, 3, 128, 376)), "") << "the last row needs no padding";
}

TEST(PointView, layoutsThatDoNot) {
  EXPECT_EQ(layoutFault(view(10, 3, 128, 375)),
            "data shorter than announced: 10 x 3 points, point_step 12, row_step 128, 375 bytes");
  EXPECT_NE(layoutFault(view(10, 3, 119, 360)), "");
  EXPECT_NE(layoutFault(view(10, 3, 0, 360)), "");
  PointView narrow = view(10, 1, 120, 120);
  narrow.point_step = 10;
  EXPECT_EQ(layoutFault(narrow), "field 'z' ends at byte 12, point_step is 10");
  narrow.point_step = 0;
  EXPECT_EQ(layoutFault(narrow), "point_step is 0");
}

TEST(PointView, announcedNumbersMayBeOfAnySize) {
  const std::size_t huge = std::numeric_limits<std::uint32_t>::max();
  EXPECT_NE(layoutFault(view(huge, huge, huge, 1000)), "");
  EXPECT_NE(layoutFault(view(1, huge, huge, 1000)), "");
  PointView far = view(10, 1, 120, 120);
  far.fields[0].offset = huge;
  EXPECT_NE(layoutFault(far), "");
}

}  // namespace
}  // namespace revisit_slam
