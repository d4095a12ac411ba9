// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/coloured_cloud.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace revisit_slam {
namespace {

constexpr std::uint32_t kPointBytes = 4 * sizeof(float);

sensor_msgs::PointField fieldOf(const char* name, std::uint32_t index) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = index * sizeof(float);
  field.datatype = sensor_msgs::PointField::FLOAT32;
  field.count = 1;
  return field;
}

/// As rviz and PCL read it: a float whose bits are 0x00RRGGBB.
std::uint32_t packed(const std_msgs::ColorRGBA& colour) {
  const auto byte = [](float share) { return static_cast<std::uint32_t>(255.0f * share); };
  return byte(colour.r) << 16 | byte(colour.g) << 8 | byte(colour.b);
}

}  // namespace

ColouredCloud::ColouredCloud(const std::string& frame, std::size_t total, int max_points)
    : total_(total), shown_(std::min<std::size_t>(total, max_points)) {
  cloud_.header.frame_id = frame;
  cloud_.fields = {fieldOf("x", 0), fieldOf("y", 1), fieldOf("z", 2), fieldOf("rgb", 3)};
  cloud_.height = 1;
  cloud_.point_step = kPointBytes;
  cloud_.is_dense = 1;
  cloud_.data.reserve(shown_ * kPointBytes);
}

void ColouredCloud::add(const CloudPart& part) {
  const std::uint32_t rgb = packed(part.colour);
  for (const Eigen::Vector3f& point : *part.points) {
    ++index_;
    if (index_ * shown_ / total_ == (index_ - 1) * shown_ / total_) continue;
    const Eigen::Vector3f placed =
        (part.T_map_points * Eigen::Vector3d(point.cast<double>())).cast<float>();
    const std::size_t at = cloud_.data.size();
    cloud_.data.resize(at + kPointBytes);
    std::memcpy(&cloud_.data[at], placed.data(), 3 * sizeof(float));
    std::memcpy(&cloud_.data[at + 3 * sizeof(float)], &rgb, sizeof(rgb));
  }
}

sensor_msgs::PointCloud2 ColouredCloud::take() {
  cloud_.width = static_cast<std::uint32_t>(cloud_.data.size() / kPointBytes);
  cloud_.row_step = static_cast<std::uint32_t>(cloud_.data.size());
  return std::move(cloud_);
}

sensor_msgs::PointCloud2 toColouredCloud(const std::vector<CloudPart>& parts,
                                         const std::string& frame, int max_points) {
  std::size_t total = 0;
  for (const CloudPart& part : parts) total += part.points->size();
  ColouredCloud cloud(frame, total, max_points);
  for (const CloudPart& part : parts) cloud.add(part);
  return cloud.take();
}

}  // namespace revisit_slam
