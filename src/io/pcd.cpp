// SPDX-License-Identifier: MIT
#include "revisit_slam/io/pcd.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cstdio>
#include <stdexcept>

#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {

static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float), "points are written as they lie");

void writePcd(const std::string& path, const Points& points) {
  if (points.empty()) throw std::runtime_error("no points to write to '" + path + "'");
  writeWholeFile(path, [&](const std::string& temporary) {
    PcdStream stream(temporary);
    stream.write(points);
    stream.finish();
  });
}

Points readPcdPoints(const std::string& path) {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  bool read = false;
  try {
    read = pcl::PCDReader().read(path, cloud) == 0;
  } catch (const pcl::PCLException&) {
  }
  if (!read) throw std::runtime_error("cannot read the cloud '" + path + "'");
  Points points;
  points.reserve(cloud.size());
  for (const pcl::PointXYZ& point : cloud) points.push_back(point.getVector3fMap());
  return points;
}

PcdStream::PcdStream(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  writeHeader();
}

/// Always of one length: the count is known only at the end.
void PcdStream::writeHeader() {
  char header[256];
  std::snprintf(header, sizeof(header),
                "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"
                "TYPE F F F\nCOUNT 1 1 1\nWIDTH %012zu\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
                "POINTS %012zu\nDATA binary\n",
                count_, count_);
  file_ << header;
}

void PcdStream::write(const Points& points) {
  file_.write(reinterpret_cast<const char*>(points.data()),
              static_cast<std::streamsize>(points.size() * sizeof(points[0])));
  count_ += points.size();
}

void PcdStream::finish() {
  file_.seekp(0);
  writeHeader();
  if (!(file_ << std::flush)) throw std::runtime_error("cannot write '" + path_ + "'");
}

}  // namespace revisit_slam
