// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// `Tr` of a sequence's calib.txt: T_camera_velodyne. @throws DatasetError naming the file
Pose readCameraCalibration(const std::string& path);

/// `R` and `T` of calib_imu_to_velo.txt: T_velodyne_imu. @throws DatasetError naming the file
Pose readImuCalibration(const std::string& path);

}  // namespace revisit_slam
