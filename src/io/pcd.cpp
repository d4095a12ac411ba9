// SPDX-License-Identifier: MIT
#include "revisit_slam/io/pcd.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <stdexcept>

#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {

void writePcd(const std::string& path, const Points& points) {
  if (points.empty()) throw std::runtime_error("no points to write to '" + path + "'");
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.reserve(points.size());
  for (const Eigen::Vector3f& point : points) cloud.push_back({point.x(), point.y(), point.z()});
  writeWholeFile(path, [&](const std::string& temporary) {
    try {
      if (pcl::PCDWriter().writeBinary(temporary, cloud) == 0) return;
    } catch (const pcl::IOException&) {
    }
    throw std::runtime_error("cannot write '" + path + "'");
  });
}

}  // namespace revisit_slam
