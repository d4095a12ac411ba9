// SPDX-License-Identifier: MIT
// HeLiPR (Jung et al., IJRR 2024). Byte layouts: the dataset's own player, HeLiPR-File-Player.
// That times count from the stamp in the file's name: its HeLiPR-Pointcloud-Toolbox.
#include <cctype>

#include "files.h"
#include "record_cloud.h"
#include "revisit_slam/datasets/readers.h"
#include "text_rows.h"

namespace revisit_slam {
namespace {

/// Aeva's points have an intensity from the first scan after this one on.
constexpr std::int64_t last_aeva_without_intensity = 1691936557946849179;

RecordLayout layoutOf(const std::string& sensor, Stamp stamp) {
  constexpr NumberType u8 = NumberType::uint8, u16 = NumberType::uint16, i32 = NumberType::int32,
                       u32 = NumberType::uint32, f32 = NumberType::float32;
  RecordLayout layout{{"x", f32}, {"y", f32}, {"z", f32}};
  const auto add = [&](const RecordLayout& more) {
    layout.insert(layout.end(), more.begin(), more.end());
  };
  if (sensor == "Ouster")
    add({{"intensity", f32}, {"t", u32}, {"reflectivity", u16}, {"ring", u16}, {"ambient", u16}});
  if (sensor == "Avia")
    add({{"reflectivity", u8}, {"tag", u8}, {"line", u8}, {"offset_time", u32}});
  if (sensor == "Velodyne") add({{"intensity", f32}, {"ring", u16}, {"time", f32}});
  if (sensor == "Aeva") {
    add({{"reflectivity", f32}, {"velocity", f32}, {"time_offset_ns", i32}, {"line_index", u8}});
    if (stamp.nanoseconds > last_aeva_without_intensity) add({{"intensity", f32}});
  }
  return layout;
}

std::string lowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

class Helipr : public DatasetScans {
 public:
  Helipr(const std::string& folder, const std::string& sensor)
      : DatasetScans(
            lowerCase(sensor),
            scansByStamp(numberedFiles(requireBelow(folder, {"LiDAR/" + sensor, sensor}), ".bin"))),
        sensor_(sensor),
        truth_(findBelow(
            folder, {"LiDAR_GT/" + sensor + "_gt.txt", "LiDAR_GT/global_" + sensor + "_gt.txt"})) {}

  std::optional<Trajectory> groundTruth() const override {
    if (!truth_) return std::nullopt;
    Trajectory truth;
    forEachRow(*truth_, 8, [&](const TextRow& row) {
      truth.push_back({{row.integer(0)}, row.positionAndQuaternion(1)});
    });
    return truth;
  }

 private:
  PointCloud readPoints(std::size_t index) const override {
    return readRecords(file(index).path, layoutOf(sensor_, file(index).stamp));
  }

  std::string sensor_;
  std::optional<std::string> truth_;
};

}  // namespace

DatasetScansPtr openHelipr(const std::string& folder, const std::string& sensor) {
  return std::make_unique<Helipr>(folder, sensor);
}

}  // namespace revisit_slam
