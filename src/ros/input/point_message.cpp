// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/point_message.h"

#include <stdexcept>

namespace revisit_slam {

const std::uint8_t* MessageBytes::take(std::size_t count) {
  if (count > size_ - next_) {
    throw std::runtime_error("message ends at byte " + std::to_string(size_) + ", " +
                             std::to_string(count) + " more wanted at " + std::to_string(next_));
  }
  const std::uint8_t* start = data_ + next_;
  next_ += count;
  return start;
}

std::string MessageBytes::text() {
  const auto length = number<std::uint32_t>();
  const std::uint8_t* start = take(length);
  return {start, start + length};
}

void MessageBytes::header(PointMessage& message) {
  number<std::uint32_t>();  // seq
  const std::int64_t seconds = number<std::uint32_t>();
  message.header_stamp = {seconds * 1'000'000'000 + number<std::uint32_t>()};
  message.frame_id = text();
}

void MessageBytes::expectEnd() const {
  if (next_ < size_) {
    throw std::runtime_error(std::to_string(size_ - next_) + " bytes after the last field");
  }
}

PointMessage parsePointCloud2(MessageBytes reader) {
  PointMessage message;
  reader.header(message);
  PointView& view = message.points;
  view.height = reader.number<std::uint32_t>();
  view.width = reader.number<std::uint32_t>();
  for (auto left = reader.number<std::uint32_t>(); left > 0; --left) {
    PointField field;
    field.name = reader.text();
    field.offset = reader.number<std::uint32_t>();
    field.type = numberTypeFromPointField(reader.number<std::uint8_t>());
    reader.number<std::uint32_t>();  // count
    view.fields.push_back(field);
  }
  view.swapped = reader.number<std::uint8_t>() != 0;
  view.point_step = reader.number<std::uint32_t>();
  view.row_step = reader.number<std::uint32_t>();
  view.size = reader.number<std::uint32_t>();
  view.data = reader.take(view.size);
  reader.number<std::uint8_t>();  // is_dense
  reader.expectEnd();
  return message;
}

}  // namespace revisit_slam
