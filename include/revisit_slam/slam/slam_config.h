// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/information/information_config.h"
#include "revisit_slam/input/scan_input_config.h"
#include "revisit_slam/loops/search/loops_config.h"
#include "revisit_slam/loops/search/retroactive_search.h"
#include "revisit_slam/mapping/mapping_config.h"
#include "revisit_slam/occupancy/occupancy_config.h"
#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/pose_graph/back_end_config.h"
#include "revisit_slam/slam/background_config.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

struct FramesConfig {
  std::string map = "map";
  std::string odom = "odom";
  std::string base = "base_link";

  template <typename Visitor>
  void visit(Visitor& v) {
    v("map", map, Choices{}, "", "frame of the corrected map; the odometry's frame moves in it");
    v("odom", odom, Choices{}, "", "frame in which the odometry moves, without jumps");
    v("base", base, Choices{}, "", "frame whose pose is estimated; empty: the sensor's own");
  }
};

/// Running beside a live sensor; nothing of this changes results unless scans are lost.
struct LiveConfig {
  int queue_size = 100;
  double diagnostics_period = 1.0;
  std::string folder;
  bool broadcast_map = true;
  double transform_rate = 20.0;
  double transform_tolerance = 0.1;
  double transform_patience = 10.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("queue_size", queue_size, Range{1, 10000}, "scans",
      "scans that may wait; when more come the oldest is dropped and counted");
    v("diagnostics_period", diagnostics_period, Range{0.1, 60.0}, "s", "between two diagnostics");
    v("folder", folder, Choices{}, "",
      "where each drive gets a folder, written to as it goes; empty: only what is asked for");
    v("broadcast_map", broadcast_map, "broadcast the transform from the map to the odometry frame");
    v("transform_rate", transform_rate, Range{0.1, 1000.0}, "Hz", "of that transform");
    v("transform_tolerance", transform_tolerance, Range{0.0, 10.0}, "s",
      "it is dated so far ahead of the newest scan");
    v("transform_patience", transform_patience, Range{0.0, 3600.0}, "s",
      "longest wait for the transform of a sensor's frame when its first scan has come; then its "
      "scans "
      "are dropped and counted until there is one. Raise it if transforms come late at start; "
      "lower it "
      "if scans of another sensor must not wait");
  }
};

/// All parameters, nested as the modules are.
struct SlamConfig {
  FramesConfig frames;
  ScanInputConfig input;
  OdometryConfig odometry;
  InformationConfig information;
  MappingConfig mapping;
  OccupancyConfig occupancy;
  LoopsConfig loops;
  RetroactiveConfig retroactive;
  BackEndConfig backend;
  BackgroundConfig background;
  LiveConfig live;

  template <typename Visitor>
  void visit(Visitor& v) {
    v.group("frames", frames);
    v.group("input", input);
    v.group("odometry", odometry);
    v.group("information", information);
    v.group("mapping", mapping);
    v.group("occupancy", occupancy);
    v.group("loops", loops);
    v.group("retroactive", retroactive);
    v.group("backend", backend);
    v.group("background", background);
    v.group("live", live);
  }
};

}  // namespace revisit_slam
