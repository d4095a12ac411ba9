// SPDX-License-Identifier: MIT
#include "ouster_columns.h"

#include "record_cloud.h"

namespace revisit_slam {

void addColumnTimes(PointCloud& cloud) {
  constexpr std::size_t beams = 64, columns = 1024;
  constexpr std::size_t period = 100'000'000;  // ns
  if (cloud.points() != beams * columns) return;
  std::vector<std::uint32_t> times(beams * columns);
  for (std::size_t i = 0; i < times.size(); ++i)
    times[i] = static_cast<std::uint32_t>(i / beams * period / columns);
  addTimes(cloud, times);
}

}  // namespace revisit_slam
