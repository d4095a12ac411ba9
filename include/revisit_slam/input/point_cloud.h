// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "revisit_slam/input/point_view.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// A recorded scan that owns its bytes: rows without gaps, numbers little-endian.
struct PointCloud {
  Stamp stamp;
  std::string frame_id;
  std::size_t width = 0;
  std::size_t height = 1;
  std::size_t point_step = 0;
  std::vector<PointField> fields;
  std::vector<std::uint8_t> data;

  std::size_t points() const { return width * height; }
};

/// Valid as long as the cloud is.
PointView viewOf(const PointCloud& cloud);

}  // namespace revisit_slam
