// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// One line of a table in a text file. What cannot be parsed throws DatasetError naming file and
/// line.
struct TextRow {
  const std::string& path;
  std::size_t line;
  std::vector<std::string> words;

  /// A finite number.
  double number(std::size_t column) const;
  std::int64_t integer(std::size_t column) const;
  /// Decimal seconds, all digits of them.
  Stamp seconds(std::size_t column) const;
  /// A position and a quaternion x y z qx qy qz qw from that column on.
  Pose positionAndQuaternion(std::size_t column) const;
  /// Rows 1-3 of a 4x4 matrix from that column on.
  Pose matrix(std::size_t column) const;

  [[noreturn]] void fail(const std::string& what) const;
};

/// Calls `use` with each line, its words parted by blanks or commas; without empty lines and those
/// that start with '#'. @throws DatasetError where the file cannot be read, or a line has not
/// `columns` words.
void forEachRow(const std::string& path, std::size_t columns,
                const std::function<void(const TextRow&)>& use);

}  // namespace revisit_slam
