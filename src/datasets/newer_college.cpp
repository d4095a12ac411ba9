// SPDX-License-Identifier: MIT
// Newer College 2020 (Ramezani et al., IROS 2020), scans as PCD files. File names and the place of
// the sensor: KISS-ICP's reader.
#include <regex>

#include "files.h"
#include "ouster_columns.h"
#include "pcd_cloud.h"
#include "revisit_slam/datasets/readers.h"
#include "text_rows.h"

namespace revisit_slam {
namespace {

/// cloud_SECONDS_NANOSECONDS
std::optional<std::int64_t> stampInName(const std::string& stem) {
  static const std::regex pattern("cloud_([0-9]{1,9}|[1-8][0-9]{9})_([0-9]{1,9})");
  std::smatch parts;
  if (!std::regex_match(stem, parts, pattern)) return std::nullopt;
  return std::stoll(parts[1]) * 1'000'000'000 + std::stoll(parts[2]);
}

/// The Ouster in the frame of the ground truth, that of the left camera.
Pose cameraToOuster() {
  return {Eigen::Quaterniond(0.383, 0.0, 0.0, 0.924).normalized(), {-0.084, -0.025, 0.050}};
}

class NewerCollege : public DatasetScans {
 public:
  explicit NewerCollege(const std::string& folder)
      : DatasetScans("os1_lidar",
                     scansByStamp(numberedFiles(
                         requireBelow(folder, {"raw_format/ouster_scan", "ouster_scan"}), ".pcd",
                         stampInName))),
        truth_(findBelow(folder, {"ground_truth/registered_poses.csv"})) {}

  std::optional<Trajectory> groundTruth() const override {
    if (!truth_) return std::nullopt;
    const Pose T_camera_ouster = cameraToOuster();
    Trajectory truth;
    forEachRow(*truth_, 9, [&](const TextRow& row) {
      constexpr std::int64_t second = 1'000'000'000;  // ns
      const std::int64_t seconds = row.integer(0), nanoseconds = row.integer(1);
      if (seconds < 0 || seconds >= 9 * second || nanoseconds < 0 || nanoseconds >= second)
        row.fail("no seconds and nanoseconds");
      const std::int64_t stamp = seconds * second + nanoseconds;
      truth.push_back({{stamp}, row.positionAndQuaternion(2) * T_camera_ouster});
    });
    return truth;
  }

 private:
  PointCloud readPoints(std::size_t index) const override {
    PointCloud cloud = readPcd(file(index).path);
    if (!hasField(cloud, "t")) addColumnTimes(cloud);
    return cloud;
  }

  std::optional<std::string> truth_;
};

}  // namespace

DatasetScansPtr openNewerCollege(const std::string& folder) {
  return std::make_unique<NewerCollege>(folder);
}

}  // namespace revisit_slam
