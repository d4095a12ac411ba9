// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace revisit_slam {

struct TestPoint {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double time = 0.0;
};

/// Points on a circle, with times from first to last in equal steps.
inline std::vector<TestPoint> sweep(double first, double last, std::size_t count = 200) {
  std::vector<TestPoint> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count - 1);
    points[i] = {10 * std::cos(6 * part), 10 * std::sin(6 * part), 1.0,
                 first + part * (last - first)};
  }
  return points;
}

/// Makes messages as drivers do: any types, offsets, byte order and padding.
class PointCloudBuilder {
 public:
  using Field = sensor_msgs::PointField;

  explicit PointCloudBuilder(std::int64_t stamp_ns = 1'700'000'000'000'000'000) {
    cloud_.header.stamp.fromNSec(static_cast<std::uint64_t>(stamp_ns));
    cloud_.header.frame_id = "lidar";
    cloud_.height = 1;
  }

  /// The value of a field of another name than x, y and z is the time.
  PointCloudBuilder& field(const std::string& name, std::uint8_t type) {
    return field(name, type, cloud_.point_step);
  }
  PointCloudBuilder& field(const std::string& name, std::uint8_t type, std::uint32_t offset) {
    Field field;
    field.name = name;
    field.datatype = type;
    field.offset = offset;
    field.count = 1;
    cloud_.fields.push_back(field);
    cloud_.point_step = std::max(cloud_.point_step, offset + bytesOf(type));
    return *this;
  }
  PointCloudBuilder& xyz(std::uint8_t type = Field::FLOAT32) {
    return field("x", type).field("y", type).field("z", type);
  }
  PointCloudBuilder& bigEndian() {
    cloud_.is_bigendian = 1;
    return *this;
  }
  PointCloudBuilder& rows(std::uint32_t height, std::uint32_t padding = 0) {
    cloud_.height = height;
    padding_ = padding;
    return *this;
  }

  sensor_msgs::PointCloud2 build(const std::vector<TestPoint>& points) {
    cloud_.width = static_cast<std::uint32_t>(points.size()) / cloud_.height;
    cloud_.row_step = cloud_.width * cloud_.point_step + padding_;
    // Padding is not zero, so that reading it would show.
    cloud_.data.assign(std::size_t{cloud_.row_step} * cloud_.height, 0x41);
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::uint8_t* start = cloud_.data.data() + i / cloud_.width * cloud_.row_step +
                            i % cloud_.width * cloud_.point_step;
      for (const Field& field : cloud_.fields) store(start, field, valueOf(points[i], field.name));
    }
    return cloud_;
  }

 private:
  static std::uint32_t bytesOf(std::uint8_t type) {
    constexpr std::uint32_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[type];
  }
  static double valueOf(const TestPoint& p, const std::string& name) {
    return name == "x" ? p.x : name == "y" ? p.y : name == "z" ? p.z : p.time;
  }
  template <typename T>
  void storeAs(std::uint8_t* to, double value) const {
    const T number = static_cast<T>(value);
    std::memcpy(to, &number, sizeof(T));
    if (cloud_.is_bigendian) std::reverse(to, to + sizeof(T));
  }
  void store(std::uint8_t* start, const Field& field, double value) const {
    std::uint8_t* to = start + field.offset;
    switch (field.datatype) {
      case Field::INT8:
        return storeAs<std::int8_t>(to, value);
      case Field::UINT8:
        return storeAs<std::uint8_t>(to, value);
      case Field::INT16:
        return storeAs<std::int16_t>(to, value);
      case Field::UINT16:
        return storeAs<std::uint16_t>(to, value);
      case Field::INT32:
        return storeAs<std::int32_t>(to, value);
      case Field::UINT32:
        return storeAs<std::uint32_t>(to, value);
      case Field::FLOAT32:
        return storeAs<float>(to, value);
      default:
        return storeAs<double>(to, value);
    }
  }

  sensor_msgs::PointCloud2 cloud_;
  std::uint32_t padding_ = 0;
};

}  // namespace revisit_slam
