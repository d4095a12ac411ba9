// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/coloured_cloud.h"

#include <algorithm>
#include <cstring>

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

sensor_msgs::PointCloud2 toColouredCloud(const std::vector<CloudPart>& parts,
                                         const std::string& frame, int max_points) {
  std::size_t total = 0;
  for (const CloudPart& part : parts) total += part.points->size();
  const std::size_t shown = std::min<std::size_t>(total, max_points);

  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = frame;
  cloud.fields = {fieldOf("x", 0), fieldOf("y", 1), fieldOf("z", 2), fieldOf("rgb", 3)};
  cloud.height = 1;
  cloud.point_step = kPointBytes;
  cloud.is_dense = 1;
  cloud.data.reserve(shown * kPointBytes);
  std::size_t index = 0;
  for (const CloudPart& part : parts) {
    const std::uint32_t rgb = packed(part.colour);
    for (const Eigen::Vector3f& point : *part.points) {
      ++index;
      if (index * shown / total == (index - 1) * shown / total) continue;
      const Eigen::Vector3f placed =
          (part.T_map_points * Eigen::Vector3d(point.cast<double>())).cast<float>();
      const std::size_t at = cloud.data.size();
      cloud.data.resize(at + kPointBytes);
      std::memcpy(&cloud.data[at], placed.data(), 3 * sizeof(float));
      std::memcpy(&cloud.data[at + 3 * sizeof(float)], &rgb, sizeof(rgb));
    }
  }
  cloud.width = static_cast<std::uint32_t>(cloud.data.size() / kPointBytes);
  cloud.row_step = static_cast<std::uint32_t>(cloud.data.size());
  return cloud;
}

}  // namespace revisit_slam
