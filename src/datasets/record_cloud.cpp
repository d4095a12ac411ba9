// SPDX-License-Identifier: MIT
#include "record_cloud.h"

#include <cstring>
#include <utility>

#include "files.h"

namespace revisit_slam {
namespace {

void addField(PointCloud& cloud, const RecordField& added) {
  PointField field;
  field.name = added.name;
  field.type = added.type;
  field.offset = cloud.point_step;
  cloud.fields.push_back(field);
  cloud.point_step += sizeOf(added.type);
}

}  // namespace

PointCloud readRecords(const std::string& path, const RecordLayout& layout) {
  PointCloud cloud;
  for (const RecordField& field : layout) addField(cloud, field);
  cloud.data = readBytes(path);
  if (cloud.data.size() % cloud.point_step != 0)
    throw DatasetError(path, std::to_string(cloud.data.size()) + " bytes are no whole number of " +
                                 std::to_string(cloud.point_step) + "-byte points");
  cloud.width = cloud.data.size() / cloud.point_step;
  return cloud;
}

void addTimes(PointCloud& cloud, const std::vector<std::uint32_t>& times) {
  const std::size_t before = cloud.point_step;
  addField(cloud, {"t", NumberType::uint32});
  std::vector<std::uint8_t> data(times.size() * cloud.point_step);
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::uint8_t* point = data.data() + i * cloud.point_step;
    std::memcpy(point, cloud.data.data() + i * before, before);
    std::memcpy(point + before, &times[i], sizeof(times[i]));
  }
  cloud.data = std::move(data);
}

const RecordLayout& xyzAndIntensity() {
  static const RecordLayout layout{{"x", NumberType::float32},
                                   {"y", NumberType::float32},
                                   {"z", NumberType::float32},
                                   {"intensity", NumberType::float32}};
  return layout;
}

}  // namespace revisit_slam
