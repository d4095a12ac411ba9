// SPDX-License-Identifier: MIT
// KITTI odometry (Geiger et al., CVPR 2012). Its clouds have been deskewed to the stamps of
// times.txt (readme of the dataset), so they carry no point times.
#include <filesystem>

#include "files.h"
#include "kitti_calibration.h"
#include "kitti_points.h"
#include "revisit_slam/datasets/readers.h"
#include "text_rows.h"

namespace revisit_slam {
namespace {

namespace fs = std::filesystem;

/// times.txt starts at zero, which is no stamp in ROS.
constexpr std::int64_t first_stamp = 1'000'000'000;

std::vector<Stamp> readTimes(const std::string& path) {
  std::vector<Stamp> times;
  forEachRow(path, 1, [&](const TextRow& row) {
    times.push_back({row.seconds(0).nanoseconds + first_stamp});
  });
  return times;
}

/// A scan's number is its place in the list of times.
std::vector<ScanFile> stampedScans(const std::string& folder) {
  const std::string time_file = requireBelow(folder, {"times.txt"});
  const std::vector<Stamp> times = readTimes(time_file);
  std::vector<ScanFile> scans;
  for (const NumberedFile& file : numberedFiles(requireBelow(folder, {"velodyne"}), ".bin")) {
    const auto index = static_cast<std::size_t>(file.number);
    if (index >= times.size())
      throw DatasetError(time_file, "has no stamp for scan " + std::to_string(file.number));
    scans.push_back({file.path, times[index]});
  }
  return scans;
}

/// poses/NN.txt beside the folder of the sequences, or poses.txt in the sequence itself.
std::optional<std::string> findPoses(const std::string& folder) {
  const fs::path sequence = fs::absolute(folder + "/.").lexically_normal().parent_path();
  return findBelow(folder, {"poses.txt", "../../poses/" + sequence.filename().string() + ".txt"});
}

class KittiOdometry : public DatasetScans {
 public:
  KittiOdometry(const std::string& folder, const DatasetOptions& options)
      : DatasetScans("velodyne", stampedScans(folder)),
        folder_(folder),
        options_(options),
        poses_(findPoses(folder)) {}

  /// The file has poses of the left camera; these are moved to the velodyne.
  std::optional<Trajectory> groundTruth() const override {
    if (!poses_) return std::nullopt;
    const std::vector<Stamp> times = readTimes(requireBelow(folder_, {"times.txt"}));
    const Pose T_camera_velodyne = readCameraCalibration(requireBelow(folder_, {"calib.txt"}));
    Trajectory truth;
    forEachRow(*poses_, 12, [&](const TextRow& row) {
      if (truth.size() == times.size()) row.fail("more poses than stamps in times.txt");
      truth.push_back(
          {times[truth.size()], T_camera_velodyne.inverse() * row.matrix(0) * T_camera_velodyne});
    });
    return truth;
  }

 private:
  PointCloud readPoints(std::size_t index) const override {
    return readKittiPoints(file(index).path, options_);
  }

  std::string folder_;
  DatasetOptions options_;
  std::optional<std::string> poses_;
};

}  // namespace

DatasetScansPtr openKittiOdometry(const std::string& folder, const DatasetOptions& options) {
  return std::make_unique<KittiOdometry>(folder, options);
}

}  // namespace revisit_slam
