// SPDX-License-Identifier: MIT
// KITTI raw (Geiger et al., IJRR 2013): clouds as measured, without point times. These are made
// from the direction of the points between the start and the end of the sweep, as CT-ICP and
// KISS-ICP make them: clockwise seen from above, from behind the car. (The dataset's readme says
// counter-clockwise; docs/datasets.md has a measurement.)
#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

#include "files.h"
#include "kitti_calibration.h"
#include "kitti_oxts.h"
#include "kitti_points.h"
#include "record_cloud.h"
#include "revisit_slam/datasets/readers.h"
#include "revisit_slam/input/azimuth_times.h"

namespace revisit_slam {
namespace {

struct Sweeps {
  /// By the number of the scan.
  std::map<std::size_t, Stamp> starts, ends;
};

/// timestamps.txt has when the sensor looks ahead, half a turn after the start.
Sweeps readSweeps(const std::string& folder) {
  constexpr std::int64_t half_turn = 50'000'000;  // ns
  const auto starts = findBelow(folder, {"timestamps_start.txt"});
  const auto ends = findBelow(folder, {"timestamps_end.txt"});
  if (starts && ends) return {readKittiDates(*starts), readKittiDates(*ends)};
  Sweeps sweeps;
  for (const auto& [scan, middle] : readKittiDates(requireBelow(folder, {"timestamps.txt"}))) {
    sweeps.starts[scan] = {middle.nanoseconds - half_turn};
    sweeps.ends[scan] = {middle.nanoseconds + half_turn};
  }
  return sweeps;
}

struct Scans {
  std::vector<ScanFile> files;
  /// Nanoseconds that each sweep lasts.
  std::vector<std::int64_t> durations;
};

Scans stampedScans(const std::string& folder) {
  constexpr std::int64_t longest_sweep = 1'000'000'000;  // ns
  const Sweeps sweeps = readSweeps(folder);
  Scans scans;
  for (const NumberedFile& file : numberedFiles(requireBelow(folder, {"data"}), ".bin")) {
    const auto index = static_cast<std::size_t>(file.number);
    if (sweeps.starts.count(index) == 0 || sweeps.ends.count(index) == 0)
      throw DatasetError(folder, "the files of stamps have none for scan " + std::to_string(index));
    const Stamp start = sweeps.starts.at(index), end = sweeps.ends.at(index);
    const std::int64_t duration = end.nanoseconds - start.nanoseconds;
    if (duration <= 0 || duration > longest_sweep)
      throw DatasetError(folder, "by its stamps, scan " + std::to_string(index) + " lasts " +
                                     std::to_string(duration) + " ns");
    scans.files.push_back({file.path, start});
    scans.durations.push_back(duration);
  }
  return scans;
}

Points pointsOf(const PointCloud& cloud) {
  Points points(cloud.width);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::memcpy(points[i].data(), &cloud.data[i * cloud.point_step], sizeof(points[i]));
    if (!points[i].allFinite()) points[i].setZero();  // a direction that can be computed
  }
  return points;
}

std::vector<std::uint32_t> timesByAzimuth(const PointCloud& cloud, std::int64_t duration) {
  const std::vector<float> fractions = sweepFractions(pointsOf(cloud), AzimuthSweep{});
  std::vector<std::uint32_t> times;
  times.reserve(fractions.size());
  for (const float fraction : fractions)
    times.push_back(static_cast<std::uint32_t>(fraction * static_cast<double>(duration)));
  return times;
}

class KittiRaw : public DatasetScans {
 public:
  KittiRaw(const std::string& folder, Scans scans, const DatasetOptions& options)
      : DatasetScans("velodyne", std::move(scans.files)),
        folder_(folder),
        durations_(std::move(scans.durations)),
        options_(options) {}

  /// That of the GPS/INS, moved to the velodyne; nothing without the drive's calibration.
  std::optional<Trajectory> groundTruth() const override {
    const auto oxts = findBelow(folder_, {"oxts"});
    const auto calibration =
        findBelow(folder_, {"calib_imu_to_velo.txt", "../calib_imu_to_velo.txt"});
    if (!oxts || !calibration) return std::nullopt;
    const Pose T_imu_velodyne = readImuCalibration(*calibration).inverse();
    Trajectory truth = readOxts(*oxts);
    for (StampedPose& pose : truth) pose.T_world_base = pose.T_world_base * T_imu_velodyne;
    return truth;
  }

 private:
  PointCloud readPoints(std::size_t index) const override {
    PointCloud cloud = readKittiPoints(file(index).path, options_);
    addTimes(cloud, timesByAzimuth(cloud, durations_[index]));
    return cloud;
  }

  std::string folder_;
  std::vector<std::int64_t> durations_;
  DatasetOptions options_;
};

}  // namespace

DatasetScansPtr openKittiRaw(const std::string& folder, const DatasetOptions& options) {
  return std::make_unique<KittiRaw>(folder, stampedScans(requireBelow(folder, {"velodyne_points"})),
                                    options);
}

}  // namespace revisit_slam
