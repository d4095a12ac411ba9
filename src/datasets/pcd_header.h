// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "revisit_slam/input/number_type.h"

namespace revisit_slam {

enum class PcdEncoding { ascii, binary, binary_compressed };

struct PcdField {
  std::string name;
  /// `unknown` for integers of 8 bytes, which a cloud cannot have.
  NumberType type = NumberType::unknown;
  /// Bytes of one number, and how many numbers.
  std::uint32_t size = 0, count = 1;
  /// From the start of the point.
  std::uint32_t offset = 0;

  std::uint32_t bytes() const { return size * count; }
};

/// The head of a PCD file of version 0.7 or earlier.
struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint32_t point_step = 0;
  std::uint32_t width = 0, height = 1;
  PcdEncoding encoding = PcdEncoding::binary;
  /// Where the points begin.
  std::size_t size = 0;

  std::size_t points() const { return std::size_t{width} * height; }
};

/// @throws DatasetError naming the file unless the header is whole and agrees with itself.
PcdHeader parsePcdHeader(const std::string& path, const std::vector<std::uint8_t>& bytes);

}  // namespace revisit_slam
