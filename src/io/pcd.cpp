// SPDX-License-Identifier: MIT
#include "revisit_slam/io/pcd.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
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
  std::ifstream file(path, std::ios::binary);
  std::string line;
  bool of_ours = false;
  std::size_t count = 0;
  while (std::getline(file, line) && line != "DATA binary") {
    if (line == "FIELDS x y z") of_ours = true;
    if (line.rfind("POINTS ", 0) == 0) count = std::strtoull(line.c_str() + 7, nullptr, 10);
  }
  const std::streamoff begin = file ? static_cast<std::streamoff>(file.tellg()) : 0;
  file.seekg(0, std::ios::end);
  const auto bytes = static_cast<std::streamoff>(count * sizeof(Eigen::Vector3f));
  if (!file || !of_ours || static_cast<std::streamoff>(file.tellg()) - begin != bytes)
    throw std::runtime_error("'" + path + "' is not a whole binary PCD file with fields x y z");
  Points points(count);
  file.seekg(begin);
  if (!file.read(reinterpret_cast<char*>(points.data()), bytes))
    throw std::runtime_error("cannot read '" + path + "'");
  return points;
}

PcdStream::PcdStream(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  writeHeader();
}

/// Always of one length: the count is known only at the end.
void PcdStream::writeHeader() {
  char header[256];
  std::snprintf(
      header, sizeof(header),
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
  if (!(file_ << std::flush))
    throw std::runtime_error("cannot write '" + path_ + "': " + std::strerror(errno));
}

}  // namespace revisit_slam
