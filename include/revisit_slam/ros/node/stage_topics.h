// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "revisit_slam/mapping/map_builder.h"
#include "revisit_slam/ros/node/in_process_topic.h"
#include "revisit_slam/slam/odometry_stage.h"
#include "revisit_slam/types/informed_scan.h"
#include "revisit_slam/types/loop_closures.h"
#include "revisit_slam/types/map_correction.h"
#include "revisit_slam/types/maps_closed.h"

namespace revisit_slam {

/// Asks for the open maps to be closed.
struct CloseMaps {
  std::uint32_t request = 0;
};

}  // namespace revisit_slam

// What passes between the nodelets, within one process.
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::OdometryOutput, "revisit_slam/RegisteredScan",
                              "7265766973697473636e303030303031")
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::InformedScan, "revisit_slam/InformedScan",
                              "7265766973697473636e303030303032")
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::MapUpdate, "revisit_slam/MapUpdate",
                              "7265766973697473636e303030303033")
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::LoopClosures, "revisit_slam/LoopClosures",
                              "7265766973697473636e303030303034")
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::MapCorrection, "revisit_slam/MapCorrection",
                              "7265766973697473636e303030303035")
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::CloseMaps, "revisit_slam/CloseMaps",
                              "7265766973697473636e303030303036")
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::MapsClosed, "revisit_slam/MapsClosed",
                              "7265766973697473636e303030303037")
