// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/livox_custom_msg.h"

#include <sstream>

namespace revisit_slam {
namespace {

constexpr const char* custom_msg_md5sum = "e4d6829bdfe657cb6c21a746c86b21a6";
constexpr std::size_t point_bytes = 19;

PointView packedPoints(const std::uint8_t* data, std::size_t count) {
  PointView view;
  view.data = data;
  view.size = count * point_bytes;
  view.width = count;
  view.height = 1;
  view.point_step = point_bytes;
  view.row_step = view.size;
  view.fields = {{"offset_time", NumberType::uint32, 0},  {"x", NumberType::float32, 4},
                 {"y", NumberType::float32, 8},           {"z", NumberType::float32, 12},
                 {"reflectivity", NumberType::uint8, 16}, {"tag", NumberType::uint8, 17},
                 {"line", NumberType::uint8, 18}};
  return view;
}

/// The types of the fields of a message definition and of those it contains, which fix its layout.
std::string fieldTypes(const std::string& definition) {
  std::istringstream lines(definition);
  std::string types;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string type;
    if (!(words >> type) || type.find('=') == 0) continue;
    if (type == "MSG:") words >> type;
    types += type.substr(type.find('/') == std::string::npos ? 0 : type.find('/') + 1) + " ";
  }
  return types;
}

}  // namespace

bool isLivoxCustomMsg(const std::string& datatype) {
  return datatype == "livox_ros_driver/CustomMsg" || datatype == "livox_ros_driver2/CustomMsg";
}

bool hasLivoxLayout(const std::string& md5sum, const std::string& definition) {
  if (md5sum == custom_msg_md5sum) return true;
  const std::string message = "Header uint64 uint32 uint8 uint8[3] CustomPoint[] ";
  const std::string header = "Header uint32 time string ";
  const std::string point = "CustomPoint uint32 float32 float32 float32 uint8 uint8 uint8 ";
  const std::string types = fieldTypes(definition);
  return types == message + header + point || types == message + point + header;
}

LivoxCustomMsg parseLivoxCustomMsg(const std::vector<std::uint8_t>& bytes) {
  LivoxCustomMsg message;
  MessageBytes reader(bytes);
  reader.header(message);
  message.timebase = {static_cast<std::int64_t>(reader.number<std::uint64_t>())};
  reader.take(sizeof(std::uint32_t) +
              4);  // point_num, lidar_id, rsvd: the array has its own length
  const std::size_t count = reader.number<std::uint32_t>();
  message.points = packedPoints(reader.take(count * point_bytes), count);
  reader.expectEnd();
  return message;
}

}  // namespace revisit_slam
