// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/icp/local_voxel_map.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Share of the points that the sensor saw through a plane of the map, 0 ... 1: their rays meet a
/// map point on a plane, not at a grazing angle, two voxels or more before they end. In a wrong
/// place many do, also where most points fit, as in one street and another. What stands in the way
/// of rays, a car that stops beside the robot, does not change it. Points nearer than four voxels
/// do not count. Of many points, 500 are looked at.
double shareSeenThrough(const Points& points_base, const Eigen::Vector3d& sensor_base,
                        const Pose& T_odom_base, const LocalVoxelMap& map);

}  // namespace revisit_slam
