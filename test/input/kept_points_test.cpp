// SPDX-License-Identifier: MIT
#include "revisit_slam/input/kept_points.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace revisit_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Points of x, y, z as float32 and one more field.
template <typename Value>
struct Message {
  Message(const std::string& name, NumberType type, const std::vector<Value>& values) {
    view.width = values.size();
    view.height = 1;
    view.point_step = 16;
    view.row_step = 16 * values.size();
    view.fields = {{"x", NumberType::float32, 0},
                   {"y", NumberType::float32, 4},
                   {"z", NumberType::float32, 8},
                   {name, type, 12}};
    bytes.resize(view.row_step);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const float xyz[] = {i == 1 ? kNan : 1.0f + static_cast<float>(i), 2.0f, 3.0f};
      std::memcpy(&bytes[16 * i], xyz, sizeof(xyz));
      std::memcpy(&bytes[16 * i + 12], &values[i], sizeof(Value));
    }
    view.data = bytes.data();
    view.size = bytes.size();
  }

  std::vector<float> intensities() const {
    return readIntensities(view, readPoints(view).byte_offsets);
  }

  std::vector<std::uint8_t> bytes;
  PointView view;
};

TEST(KeptPoints, IntensitiesAreThoseOfThePointsThatAreKept) {
  const Message<float> message("intensity", NumberType::float32, {1.5f, 2.5f, kNan, 4.5f});
  EXPECT_EQ(message.intensities(), (std::vector<float>{1.5f, 0.0f, 4.5f}));
}

TEST(KeptPoints, AReflectivityIsOneToo) {
  const Message<std::uint8_t> message("reflectivity", NumberType::uint8, {1, 2, 255});
  EXPECT_EQ(message.intensities(), (std::vector<float>{1.0f, 255.0f}));
}

TEST(KeptPoints, OtherFieldsAreNoIntensity) {
  EXPECT_TRUE(Message<float>("ring", NumberType::float32, {1.0f, 2.0f}).intensities().empty());
  EXPECT_TRUE(Message<float>("intensity", NumberType::unknown, {1.0f, 2.0f}).intensities().empty());
}

}  // namespace
}  // namespace revisit_slam
