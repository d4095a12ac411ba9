// SPDX-License-Identifier: MIT
#include "cloud_writer.h"

#include <cstring>

namespace revisit_slam::simulation {
namespace {

using Field = sensor_msgs::PointField;

void add(sensor_msgs::PointCloud2& cloud, const char* name, std::uint8_t type, std::uint32_t size) {
  Field field;
  field.name = name;
  field.offset = cloud.point_step;
  field.datatype = type;
  field.count = 1;
  cloud.fields.push_back(field);
  cloud.point_step += size;
}

}  // namespace

template <typename T>
void CloudWriter::put(T value) {
  std::memcpy(target_, &value, sizeof(T));
  target_ += sizeof(T);
}

sensor_msgs::PointCloud2 CloudWriter::write(const SimulatedScan& scan, std::uint32_t sequence,
                                            const std::string& frame) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.seq = sequence;
  cloud.header.stamp.fromNSec(static_cast<std::uint64_t>(scan.first.nanoseconds));
  cloud.header.frame_id = frame;
  declareFields(cloud);
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(scan.scan.points.size());
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.is_dense = true;
  cloud.data.resize(cloud.row_step);
  target_ = cloud.data.data();
  for (std::size_t i = 0; i < scan.scan.points.size(); ++i) putPoint(scan, i);
  return cloud;
}

void CloudWriter::declareFields(sensor_msgs::PointCloud2& cloud) const {
  for (const char* name : {"x", "y", "z", "intensity"}) add(cloud, name, Field::FLOAT32, 4);
  if (kind_ == SensorKind::kSpinning) {
    if (with_times_) add(cloud, "t", Field::UINT32, 4);
    add(cloud, "ring", Field::UINT16, 2);
  } else if (kind_ == SensorKind::kRosette) {
    add(cloud, "tag", Field::UINT8, 1);
    add(cloud, "line", Field::UINT8, 1);
    if (with_times_) add(cloud, "timestamp", Field::FLOAT64, 8);
  } else if (with_times_) {
    add(cloud, "time", Field::FLOAT32, 4);
  }
  if (with_labels_) add(cloud, "moving", Field::UINT8, 1);
}

void CloudWriter::putPoint(const SimulatedScan& scan, std::size_t i) {
  for (int axis = 0; axis < 3; ++axis) put<float>(scan.scan.points[i][axis]);
  put<float>(scan.intensities[i]);
  const std::uint32_t ns = scan.nanoseconds[i];
  if (kind_ == SensorKind::kSpinning) {
    if (with_times_) put<std::uint32_t>(ns);
    put<std::uint16_t>(scan.rings[i]);
  } else if (kind_ == SensorKind::kRosette) {
    put<std::uint8_t>(0x10);
    put<std::uint8_t>(static_cast<std::uint8_t>(scan.rings[i]));
    if (with_times_) put<double>(static_cast<double>(scan.first.nanoseconds + ns));
  } else if (with_times_) {
    put<float>(static_cast<float>(1e-9 * ns));
  }
  if (with_labels_) put<std::uint8_t>(scan.moving[i]);
}

}  // namespace revisit_slam::simulation
