// SPDX-License-Identifier: MIT
// Apollo-SouthBay (Lu et al., CVPR 2019). Folders and columns: KISS-ICP's reader. Its clouds have
// been deskewed (KISS-ICP pull request 307), so that their times are not to be used.
#include <map>

#include "files.h"
#include "pcd_cloud.h"
#include "revisit_slam/datasets/readers.h"
#include "revisit_slam/input/time_fields.h"
#include "text_rows.h"

namespace revisit_slam {
namespace {

/// By the number of the scan.
std::map<std::int64_t, StampedPose> readPoses(const std::string& path) {
  std::map<std::int64_t, StampedPose> poses;
  forEachRow(path, 9, [&](const TextRow& row) {
    poses[row.integer(0)] = {row.seconds(1), row.positionAndQuaternion(2)};
  });
  return poses;
}

std::vector<ScanFile> stampedScans(const std::string& folder, const std::string& pose_file) {
  const std::map<std::int64_t, StampedPose> poses = readPoses(pose_file);
  std::vector<ScanFile> scans;
  for (const NumberedFile& file : numberedFiles(requireBelow(folder, {"pcds"}), ".pcd")) {
    const auto pose = poses.find(file.number);
    if (pose == poses.end())
      throw DatasetError(pose_file, "has no stamp for scan " + std::to_string(file.number));
    scans.push_back({file.path, pose->second.stamp});
  }
  return scans;
}

class Apollo : public DatasetScans {
 public:
  Apollo(const std::string& folder, const std::string& pose_file)
      : DatasetScans("velodyne64", stampedScans(folder, pose_file)), pose_file_(pose_file) {}

  std::optional<Trajectory> groundTruth() const override {
    Trajectory truth;
    for (const auto& pose : readPoses(pose_file_)) truth.push_back(pose.second);
    return truth;
  }

 private:
  PointCloud readPoints(std::size_t index) const override {
    PointCloud cloud = readPcd(file(index).path);
    for (const PointField& field : findTimeFields(viewOf(cloud), "auto"))
      dropField(cloud, field.name);
    return cloud;
  }

  std::string pose_file_;
};

}  // namespace

DatasetScansPtr openApollo(const std::string& folder) {
  return std::make_unique<Apollo>(folder, requireBelow(folder, {"poses/gt_poses.txt"}));
}

}  // namespace revisit_slam
