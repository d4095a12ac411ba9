// SPDX-License-Identifier: MIT
#include "pcd_cloud.h"

#include <pcl/io/lzf.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "files.h"
#include "pcd_header.h"
#include "revisit_slam/input/load_number.h"

namespace revisit_slam {
namespace {

using Bytes = std::vector<std::uint8_t>;

[[noreturn]] void cutOff(const std::string& path, std::size_t there, std::size_t wanted) {
  throw DatasetError(path, "has " + std::to_string(there) +
                               " bytes of points, its header announces " + std::to_string(wanted));
}

Bytes binaryPoints(const std::string& path, const PcdHeader& header, const Bytes& file) {
  const std::size_t wanted = header.points() * header.point_step;
  if (file.size() - header.size != wanted) cutOff(path, file.size() - header.size, wanted);
  return {file.begin() + static_cast<std::ptrdiff_t>(header.size), file.end()};
}

/// Compressed points lie field by field; a cloud has them point by point.
Bytes pointByPoint(const PcdHeader& header, const Bytes& field_by_field) {
  Bytes data(field_by_field.size());
  const std::uint8_t* from = field_by_field.data();
  for (const PcdField& field : header.fields)
    for (std::size_t i = 0; i < header.points(); ++i, from += field.bytes())
      std::memcpy(data.data() + i * header.point_step + field.offset, from, field.bytes());
  return data;
}

Bytes compressedPoints(const std::string& path, const PcdHeader& header, const Bytes& file) {
  constexpr std::size_t best_ratio = 264;  // of LZF: three bytes stand for 264 at most
  const std::size_t there = file.size() - header.size, wanted = header.points() * header.point_step;
  if (there < 8) cutOff(path, there, wanted);
  const std::uint8_t* body = file.data() + header.size;
  const auto compressed = loadNumber<std::uint32_t, false>(body);
  const auto decompressed = loadNumber<std::uint32_t, false>(body + 4);
  if (decompressed != wanted) cutOff(path, decompressed, wanted);
  if (compressed > there - 8) cutOff(path, there - 8, compressed);
  if (wanted == 0) return {};
  const std::size_t fewest = wanted / best_ratio + 1;
  if (compressed < fewest) cutOff(path, compressed, fewest);
  Bytes field_by_field(wanted);
  const unsigned int got = pcl::lzfDecompress(body + 8, compressed, field_by_field.data(),
                                              static_cast<unsigned int>(wanted));
  if (got != wanted) throw DatasetError(path, "its compressed points are damaged");
  return pointByPoint(header, field_by_field);
}

template <typename T>
void store(double value, std::uint8_t* to) {
  // A cast of what the type cannot hold would be undefined.
  const double low = static_cast<double>(std::numeric_limits<T>::lowest());
  const double high = static_cast<double>(std::numeric_limits<T>::max());
  const bool whole = std::numeric_limits<T>::is_integer;
  const T number = whole && !(low <= value && value <= high) ? T{} : static_cast<T>(value);
  std::memcpy(to, &number, sizeof(T));
}

Bytes asciiPoints(const std::string& path, const PcdHeader& header, const Bytes& file) {
  // Each number takes two characters, so that a wrong count is known before memory is taken.
  const std::size_t there = file.size() - header.size;
  if (there / 2 + 1 < header.points()) cutOff(path, there, 2 * header.points());
  const std::string text(file.begin() + static_cast<std::ptrdiff_t>(header.size), file.end());
  const char* next = text.c_str();
  Bytes data(header.points() * header.point_step);
  for (std::size_t i = 0; i < header.points(); ++i) {
    for (const PcdField& field : header.fields) {
      for (std::uint32_t k = 0; k < field.count; ++k) {
        char* end = nullptr;
        const double value = std::strtod(next, &end);
        if (end == next)
          throw DatasetError(path, "point " + std::to_string(i) + ": no number for " + field.name);
        std::uint8_t* to = &data[i * header.point_step + field.offset + k * field.size];
        withNumberType(field.type, [&](auto zero) { store<decltype(zero)>(value, to); });
        next = end;
      }
    }
  }
  return data;
}

Bytes pointsOf(const std::string& path, const PcdHeader& header, const Bytes& file) {
  switch (header.encoding) {
    case PcdEncoding::ascii:
      return asciiPoints(path, header, file);
    case PcdEncoding::binary:
      return binaryPoints(path, header, file);
    case PcdEncoding::binary_compressed:
      return compressedPoints(path, header, file);
  }
  return {};
}

}  // namespace

PointCloud readPcd(const std::string& path) {
  const Bytes file = readBytes(path);
  const PcdHeader header = parsePcdHeader(path, file);
  PointCloud cloud;
  cloud.data = pointsOf(path, header, file);
  cloud.width = header.width;
  cloud.height = header.height;
  cloud.point_step = header.point_step;
  for (const PcdField& field : header.fields) {
    if (field.name == "_" || field.type == NumberType::unknown) continue;
    cloud.fields.push_back({field.name, field.type, field.offset, field.count});
  }
  return cloud;
}

bool hasField(const PointCloud& cloud, const std::string& name) {
  return std::any_of(cloud.fields.begin(), cloud.fields.end(),
                     [&](const auto& field) { return field.name == name; });
}

void dropField(PointCloud& cloud, const std::string& name) {
  const auto is_it = [&](const auto& field) { return field.name == name; };
  cloud.fields.erase(std::remove_if(cloud.fields.begin(), cloud.fields.end(), is_it),
                     cloud.fields.end());
}

}  // namespace revisit_slam
