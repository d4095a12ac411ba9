// SPDX-License-Identifier: MIT
#include "revisit_slam/io/cloud_file.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include "revisit_slam/io/bytes.h"
#include "revisit_slam/io/pcd.h"

namespace revisit_slam {
namespace {

Eigen::Vector3d placed(const Eigen::Vector3f& point, const CloudFrame& frame) {
  const Eigen::Vector3d p = point.cast<double>();
  return frame.place ? frame.place(p) : p;
}

/// Places points before it writes them in single precision.
class PlacingStream final : public CloudStream {
 public:
  PlacingStream(std::unique_ptr<CloudStream> stream, CloudFrame frame)
      : stream_(std::move(stream)), frame_(std::move(frame)) {}

  void write(const Points& points, const std::vector<float>& intensities) override {
    Points all;
    all.reserve(points.size());
    for (const Eigen::Vector3f& point : points) all.push_back(placed(point, frame_).cast<float>());
    stream_->write(all, intensities);
  }
  void finish() override { stream_->finish(); }

 private:
  const std::unique_ptr<CloudStream> stream_;
  const CloudFrame frame_;
};

/// A binary file whose header is written again at the end, with the same length.
class FileWithHeader : public CloudStream {
 public:
  void finish() override {
    file_.seekp(0);
    writeHeader();
    if (!(file_ << std::flush))
      throw std::runtime_error("cannot write '" + path_ + "': " + std::strerror(errno));
  }

 protected:
  explicit FileWithHeader(const std::string& path) : path_(path), file_(path, std::ios::binary) {}

  virtual void writeHeader() = 0;

  std::string path_;
  std::ofstream file_;
  std::size_t count_ = 0;
};

class PlyStream final : public FileWithHeader {
 public:
  PlyStream(const std::string& path, bool with_intensities)
      : FileWithHeader(path), with_intensities_(with_intensities) {
    writeHeader();
  }

  void write(const Points& points, const std::vector<float>& intensities) override {
    file_ << pointBytes(points, intensities, with_intensities_);
    count_ += points.size();
  }

 private:
  void writeHeader() override {
    char header[256];
    std::snprintf(header, sizeof(header),
                  "ply\nformat binary_little_endian 1.0\nelement vertex %012zu\n"
                  "property float x\nproperty float y\nproperty float z\n%send_header\n",
                  count_, with_intensities_ ? "property float intensity\n" : "");
    file_ << header;
  }

  const bool with_intensities_;
};

/// LAS 1.2, point format 0 (ASPRS, LAS Specification Version 1.2, 2008).
class LasStream final : public FileWithHeader {
 public:
  LasStream(const std::string& path, const CloudLayout& layout)
      : FileWithHeader(path), frame_(layout.frame), intensity_scale_(layout.intensity_scale) {
    writeHeader();
  }

  void write(const Points& points, const std::vector<float>& intensities) override {
    ByteWriter bytes;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d p = placed(points[i], frame_);
      least_ = least_.cwiseMin(p);
      greatest_ = greatest_.cwiseMax(p);
      for (int axis = 0; axis < 3; ++axis) bytes.put(wholeSteps(p[axis] - frame_.origin[axis]));
      bytes.put(intensities.empty() ? std::uint16_t{0}
                                    : wholeNumber(intensity_scale_ * intensities[i]));
      bytes.put(std::uint8_t{1 | 1 << 3});                              // first return of one
      for (int rest = 0; rest < 3; ++rest) bytes.put(std::uint8_t{0});  // class, angle, user data
      bytes.put(std::uint16_t{0});                                      // point source
    }
    file_ << bytes.bytes();
    count_ += points.size();
  }

 private:
  static constexpr double kScale = 0.001;  // m; 32 bits reach to 2,147 km
  static constexpr std::uint16_t kHeaderLength = 227, kPointLength = 20;

  void writeHeader() override {
    if (count_ > std::numeric_limits<std::uint32_t>::max())
      throw std::runtime_error("'" + path_ +
                               "' would have more points than LAS 1.2 can count; cut "
                               "the map into tiles");
    const auto points = static_cast<std::uint32_t>(count_);
    ByteWriter h;
    putText("LASF", 4, h);
    h.put(std::uint32_t{0});  // source, encoding
    putText("", 16, h);       // project
    h.put(std::uint8_t{1});
    h.put(std::uint8_t{2});
    putText("revisit_slam", 32, h);
    putText("revisit_slam export", 32, h);
    h.put(std::uint32_t{0});  // day and year of creation
    h.put(kHeaderLength);
    const std::string records = referenceSystem();
    h.put(static_cast<std::uint32_t>(kHeaderLength + records.size()));  // where points begin
    h.put(std::uint32_t{records.empty() ? 0u : 1u});                    // variable length records
    h.put(std::uint8_t{0});                                             // point format
    h.put(kPointLength);
    for (const std::uint32_t n : {points, points, 0u, 0u, 0u, 0u}) h.put(n);  // all, by return
    for (int axis = 0; axis < 3; ++axis) h.put(kScale);
    for (int axis = 0; axis < 3; ++axis) h.put(frame_.origin[axis]);
    for (int axis = 0; axis < 3; ++axis) {
      h.put(count_ > 0 ? greatest_[axis] : 0.0);
      h.put(count_ > 0 ? least_[axis] : 0.0);
    }
    file_ << h.bytes() << records;
  }

  /// The record of GeoTIFF keys (LAS 1.2, Sec. 3; GeoTIFF 1.0, Sec. 6) that names the system; none
  /// where there is none.
  std::string referenceSystem() const {
    if (frame_.epsg == 0) return {};
    constexpr std::uint16_t kDirectory = 34735, kModel = 1024, kProjected = 1, kSystem = 3072,
                            kUnit = 3076, kHeightUnit = 4099, kMetre = 9001;
    const std::pair<std::uint16_t, std::uint16_t> keys[] = {
        {kModel, kProjected},
        {kSystem, static_cast<std::uint16_t>(frame_.epsg)},
        {kUnit, kMetre},
        {kHeightUnit, kMetre}};
    constexpr std::uint16_t count = std::size(keys);
    ByteWriter record;
    record.put(std::uint16_t{0});
    putText("LASF_Projection", 16, record);
    record.put(kDirectory);
    record.put(static_cast<std::uint16_t>((count + 1) * 4 * sizeof(std::uint16_t)));
    putText("GeoTIFF keys", 32, record);
    for (const std::uint16_t n : {std::uint16_t{1}, std::uint16_t{1}, std::uint16_t{0}, count})
      record.put(n);  // version 1.1.0
    for (const auto& [key, value] : keys)
      for (const std::uint16_t n : {key, std::uint16_t{0}, std::uint16_t{1}, value}) record.put(n);
    return record.bytes();
  }

  static std::int32_t wholeSteps(double distance) {
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::int32_t>(std::lround(std::clamp(distance / kScale, -most, most)));
  }

  static std::uint16_t wholeNumber(float intensity) {
    constexpr float most = std::numeric_limits<std::uint16_t>::max();
    return static_cast<std::uint16_t>(std::lround(std::clamp(intensity, 0.0f, most)));
  }

  static void putText(std::string text, std::size_t length, ByteWriter& bytes) {
    text.resize(length);
    bytes.putAll(std::vector<char>(text.begin(), text.end()));
  }

  const CloudFrame frame_;
  const float intensity_scale_;
  Eigen::Vector3d least_ = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d greatest_ = -least_;
};

}  // namespace

std::unique_ptr<CloudStream> makeCloudStream(const std::string& format, const std::string& path,
                                             const CloudLayout& layout) {
  requireCloudFormat(format);
  if (format == "las") return std::make_unique<LasStream>(path, layout);
  std::unique_ptr<CloudStream> stream;
  if (format == "pcd")
    stream = std::make_unique<PcdStream>(path, layout.with_intensities);
  else
    stream = std::make_unique<PlyStream>(path, layout.with_intensities);
  return layout.frame.place ? std::make_unique<PlacingStream>(std::move(stream), layout.frame)
                            : std::move(stream);
}

std::string pointBytes(const Points& points, const std::vector<float>& intensities,
                       bool with_intensities) {
  std::string bytes;
  bytes.reserve(points.size() * (with_intensities ? 4 : 3) * sizeof(float));
  const auto append = [&bytes](const float* values, std::size_t count) {
    bytes.append(reinterpret_cast<const char*>(values), count * sizeof(float));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    append(points[i].data(), 3);
    const float intensity = intensities.empty() ? 0.0f : intensities[i];
    if (with_intensities) append(&intensity, 1);
  }
  return bytes;
}

void requireCloudFormat(const std::string& format) {
  if (format == "pcd" || format == "ply" || format == "las") return;
  if (format == "laz")
    throw std::invalid_argument(
        "LAZ is not written: export las, and compress it with laszip or "
        "'pdal translate map.las map.laz'");
  throw std::invalid_argument("'" + format + "' is no format of clouds: pcd, ply, las");
}

}  // namespace revisit_slam
