// SPDX-License-Identifier: MIT
#include "revisit_slam/io/pcd.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {

void writePcd(const std::string& path, const Points& points,
              const std::vector<float>& intensities) {
  if (points.empty()) throw std::runtime_error("no points to write to '" + path + "'");
  writeWholeFile(path, [&](const std::string& temporary) {
    PcdStream stream(temporary, !intensities.empty());
    stream.write(points, intensities);
    stream.finish();
  });
}

Points readPcdPoints(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  std::size_t floats = 0;  // of a point; 0: not of ours
  std::size_t count = 0;
  while (std::getline(file, line) && line != "DATA binary") {
    if (line == "FIELDS x y z") floats = 3;
    if (line == "FIELDS x y z intensity") floats = 4;
    if (line.rfind("POINTS ", 0) == 0) count = std::strtoull(line.c_str() + 7, nullptr, 10);
  }
  const std::streamoff begin = file ? static_cast<std::streamoff>(file.tellg()) : 0;
  file.seekg(0, std::ios::end);
  const auto bytes = static_cast<std::streamoff>(count * floats * sizeof(float));
  if (!file || floats == 0 || static_cast<std::streamoff>(file.tellg()) - begin != bytes)
    throw std::runtime_error("'" + path + "' is not a whole binary PCD file with fields x y z");
  std::vector<float> values(count * floats);
  file.seekg(begin);
  if (!file.read(reinterpret_cast<char*>(values.data()), bytes))
    throw std::runtime_error("cannot read '" + path + "'");
  Points points(count);
  for (std::size_t i = 0; i < count; ++i)
    points[i] = Eigen::Map<const Eigen::Vector3f>(&values[i * floats]);
  return points;
}

PcdStream::PcdStream(const std::string& path, bool with_intensities)
    : path_(path), with_intensities_(with_intensities), file_(path, std::ios::binary) {
  writeHeader();
}

/// Always of one length: the count is known only at the end.
void PcdStream::writeHeader() {
  char header[256];
  const bool with = with_intensities_;
  std::snprintf(
      header, sizeof(header),
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z%s\nSIZE 4 4 4%s\n"
      "TYPE F F F%s\nCOUNT 1 1 1%s\nWIDTH %012zu\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
      "POINTS %012zu\nDATA binary\n",
      with ? " intensity" : "", with ? " 4" : "", with ? " F" : "", with ? " 1" : "", count_,
      count_);
  file_ << header;
}

void PcdStream::write(const Points& points, const std::vector<float>& intensities) {
  file_ << pointBytes(points, intensities, with_intensities_);
  count_ += points.size();
}

void PcdStream::finish() {
  file_.seekp(0);
  writeHeader();
  if (!(file_ << std::flush))
    throw std::runtime_error("cannot write '" + path_ + "': " + std::strerror(errno));
}

}  // namespace revisit_slam
