// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// Lines "2011-09-26 13:02:25.951199337", by their number from 0 on; those of scans that are
/// missing are empty. KITTI does not say of which time zone; taken as UTC.
/// @throws DatasetError naming file and line
std::map<std::size_t, Stamp> readKittiDates(const std::string& path);

/// The GPS/INS poses T_world_imu of a raw drive's folder oxts, by the Mercator projection of its
/// development kit with the first latitude's scale; the world has its origin at the first position,
/// x to the east and z up. @throws DatasetError naming the file
Trajectory readOxts(const std::string& folder);

}  // namespace revisit_slam
