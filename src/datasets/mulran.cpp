// SPDX-License-Identifier: MIT
// MulRan (Kim et al., ICRA 2020). Byte layout: the dataset's own player, file_player_mulran. Order
// of the points and place of the sensor: KISS-ICP's reader.
#include "files.h"
#include "ouster_columns.h"
#include "record_cloud.h"
#include "revisit_slam/datasets/readers.h"
#include "text_rows.h"

namespace revisit_slam {
namespace {

/// The dataset's calib_base2ouster.txt: x y z in metres, roll pitch yaw in degrees.
Pose baseToOuster() {
  constexpr double degree = 3.14159265358979323846 / 180.0;
  const auto turn = [](double degrees, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(degrees * degree, axis);
  };
  return {turn(179.6654, Eigen::Vector3d::UnitZ()) * turn(0.0003, Eigen::Vector3d::UnitY()) *
              turn(0.0001, Eigen::Vector3d::UnitX()),
          {1.7042, -0.021, 1.8047}};
}

class Mulran : public DatasetScans {
 public:
  explicit Mulran(const std::string& folder)
      : DatasetScans("ouster",
                     scansByStamp(numberedFiles(
                         requireBelow(folder, {"Ouster", "sensor_data/Ouster"}), ".bin"))),
        truth_(findBelow(folder, {"global_pose.csv"})) {}

  std::optional<Trajectory> groundTruth() const override {
    if (!truth_) return std::nullopt;
    const Pose T_base_ouster = baseToOuster();
    Trajectory truth;
    forEachRow(*truth_, 13, [&](const TextRow& row) {
      truth.push_back({{row.integer(0)}, row.matrix(1) * T_base_ouster});
    });
    return truth;
  }

 private:
  PointCloud readPoints(std::size_t index) const override {
    PointCloud cloud = readRecords(file(index).path, xyzAndIntensity());
    addColumnTimes(cloud);
    return cloud;
  }

  std::optional<std::string> truth_;
};

}  // namespace

DatasetScansPtr openMulran(const std::string& folder) {
  return std::make_unique<Mulran>(folder);
}

}  // namespace revisit_slam
