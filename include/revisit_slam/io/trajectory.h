// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// A pose and the instant at which it is valid.
struct StampedPose {
  Stamp stamp;
  Pose T_world_base;
};

using Trajectory = std::vector<StampedPose>;

/// Seconds with all nine decimals.
std::string stampText(Stamp stamp);

/// One TUM line: stamp, tx ty tz qx qy qz qw.
void writeTumLine(std::ostream& out, const StampedPose& pose);

/// @throws std::runtime_error naming the file, and the line where one cannot be read.
Trajectory readTum(const std::string& path);

/// Whole or not at all. @throws std::runtime_error naming the file.
void writeTum(const std::string& path, const Trajectory& trajectory);

/// Rows 1-3 of the 4x4 matrix, one pose a line. @throws std::runtime_error naming the file.
void writeKitti(const std::string& path, const Trajectory& trajectory);

/// The poses of a KITTI file: rows 1-3 of the 4x4 matrix, one pose a line, without stamps.
/// Rotations become the nearest orthonormal ones.
/// @throws std::runtime_error naming the file, and the line where one cannot be read.
std::vector<Pose> readKitti(const std::string& path);

}  // namespace revisit_slam
