// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "revisit_slam/input/number_type.h"

namespace revisit_slam {

/// A number in every point.
struct PointField {
  std::string name;
  NumberType type = NumberType::unknown;
  std::size_t offset = 0;
  /// How many numbers of that type follow each other. Only the first is ever read.
  std::size_t count = 1;
};

/// Points in the bytes of a message, which it does not own, and where their fields are.
struct PointView {
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t point_step = 0;
  std::size_t row_step = 0;
  /// Numbers are big-endian.
  bool swapped = false;
  std::vector<PointField> fields;

  const PointField* find(const std::string& name) const;
  std::string fieldNames() const;
};

/// Why the bytes cannot hold what is announced, with the numbers; empty when they can, and then
/// every field of known type of every point can be read. There has to be a point.
std::string layoutFault(const PointView& view);

}  // namespace revisit_slam
