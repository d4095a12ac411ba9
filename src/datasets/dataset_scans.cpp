// SPDX-License-Identifier: MIT
#include "revisit_slam/datasets/dataset_scans.h"

namespace revisit_slam {

PointCloud DatasetScans::read(std::size_t index) const {
  PointCloud cloud = readPoints(index);
  cloud.stamp = scans_[index].stamp;
  cloud.frame_id = frame_;
  return cloud;
}

}  // namespace revisit_slam
