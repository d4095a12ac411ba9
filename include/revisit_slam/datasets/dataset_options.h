// SPDX-License-Identifier: MIT
#pragma once

namespace revisit_slam {

struct DatasetOptions {
  /// Raises the points of KITTI by 0.205 degrees, which its sensor's calibration lacks (Deschaud,
  /// "IMLS-SLAM", ICRA 2018; KISS-ICP does the same).
  bool correct_kitti_elevation = true;
};

}  // namespace revisit_slam
