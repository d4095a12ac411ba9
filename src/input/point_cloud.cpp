// SPDX-License-Identifier: MIT
#include "revisit_slam/input/point_cloud.h"

namespace revisit_slam {

PointView viewOf(const PointCloud& cloud) {
  PointView view;
  view.data = cloud.data.data();
  view.size = cloud.data.size();
  view.width = cloud.width;
  view.height = cloud.height;
  view.point_step = cloud.point_step;
  view.row_step = cloud.width * cloud.point_step;
  view.fields = cloud.fields;
  return view;
}

}  // namespace revisit_slam
