// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/information/information_config.h"
#include "revisit_slam/input/scan_input_config.h"
#include "revisit_slam/localization/localization_config.h"
#include "revisit_slam/loops/search/loops_config.h"
#include "revisit_slam/loops/search/retroactive_search.h"
#include "revisit_slam/mapping/mapping_config.h"
#include "revisit_slam/occupancy/occupancy_config.h"
#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/pose_graph/back_end_config.h"
#include "revisit_slam/priors/gnss_config.h"
#include "revisit_slam/priors/gravity_config.h"
#include "revisit_slam/priors/priors_config.h"
#include "revisit_slam/slam/background_config.h"
#include "revisit_slam/util/frame_name.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

struct FramesConfig {
  std::string map = "map";
  std::string odom = "odom";
  std::string base = "base_link";
  std::string earth;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("map", map, Choices{}, "",
      "name of the frame of the corrected map, in which the odometry frame moves");
    v("odom", odom, Choices{}, "",
      "name of the odometry frame, in which the base frame moves without jumps");
    v("base", base, Choices{}, "",
      "name of the frame whose pose is estimated; empty: the frame of the sensor");
    v("earth", earth, Choices{}, "",
      "name of the frame of the earth's centre (ECEF), in which the map frame is broadcast as soon "
      "as GNSS has aligned it; usually earth; empty: it is not broadcast");
  }

  /// With names as tf2 knows them.
  void dropLeadingSlashes() {
    for (std::string* frame : {&map, &odom, &base, &earth}) *frame = withoutLeadingSlash(*frame);
  }
};

/// Running beside a live sensor; nothing of this changes results unless scans are lost.
struct LiveConfig {
  int queue_size = 100;
  double diagnostics_period = 1.0;
  std::string folder, save_root, mode = "map", map;
  bool broadcast_map = true;
  bool broadcast_odom = true;
  double transform_rate = 20.0;
  double transform_tolerance = 0.1;
  double transform_patience = 10.0;
  int max_cloud_points = 200'000;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("queue_size", queue_size, Range{1, 10000}, "scans",
      "largest number of scans that may wait for the odometry; of more the oldest scan is dropped "
      "and counted. Raise it if scans are dropped in short bursts of load; lower it if poses must "
      "not come late");
    v("diagnostics_period", diagnostics_period, Range{0.1, 60.0}, "s",
      "time between two diagnostics messages. Raise it if diagnostics fill recordings; lower it "
      "if problems should show sooner");
    v("folder", folder, Choices{}, "",
      "folder in which each drive gets a folder of its own, written to during the drive; empty: "
      "files are written only on request");
    v("save_root", save_root, Choices{}, "",
      "folder below which the service save may write and the services load may read; empty: "
      "anywhere that the process may. Set it where others can call services");
    v("mode", mode, Choices{"map", "localize", "extend"}, "",
      "what is made of the drive. map: a new map; localize: its way in localization/map; extend: a "
      "map that goes on from live/map. The launch files load the nodelets for it");
    v("map", map, Choices{}, "",
      "with live/mode extend, folder of the session whose map the first drive goes on from; "
      "otherwise empty. Read by the odometry");
    v("broadcast_map", broadcast_map,
      "true: the transform from map to odometry frame is broadcast; false: another node has to do "
      "so");
    v("broadcast_odom", broadcast_odom,
      "true: the transform from odometry to base frame is broadcast; false: the robot does so, and "
      "the map frame is placed against its odometry");
    v("transform_rate", transform_rate, Range{0.1, 1000.0}, "Hz",
      "rate at which the transform from map to odometry frame is broadcast. Raise it if "
      "transforms are missed between broadcasts; lower it to reduce traffic");
    v("transform_tolerance", transform_tolerance, Range{0.0, 10.0}, "s",
      "time by which the transform from map to odometry frame is stamped ahead of the newest scan; "
      "without new scans the stamp goes on with the clock by at most 0.2 s. Raise it if lookups "
      "fail by extrapolation into the future; lower it if corrections should take effect sooner");
    v("transform_patience", transform_patience, Range{0.0, 3600.0}, "s",
      "longest wait for the transform of a sensor frame after its first scan; then its scans are "
      "dropped and counted until there is one. Raise it if transforms come late at start; lower "
      "it if scans of another sensor must not wait");
    v("max_cloud_points", max_cloud_points, Range{1000, 10'000'000}, "",
      "largest number of points of each cloud of maps for rviz (local_maps, submaps, map_cloud, "
      "prior_map, matched_submap); of more, as many are picked evenly. Raise it where graphics are "
      "fast; lower it if rviz shows few frames a second");
  }
};

/// All parameters, nested as the modules are.
struct SlamConfig {
  FramesConfig frames;
  ScanInputConfig input;
  PriorsConfig priors;
  GnssConfig gnss;
  GravityConfig gravity;
  OdometryConfig odometry;
  InformationConfig information;
  MappingConfig mapping;
  OccupancyConfig occupancy;
  LoopsConfig loops;
  RetroactiveConfig retroactive;
  BackEndConfig backend;
  LocalizationConfig localization;
  BackgroundConfig background;
  LiveConfig live;

  template <typename Visitor>
  void visit(Visitor& v) {
    v.group("frames", frames);
    v.group("input", input);
    v.group("priors", priors);
    v.group("gnss", gnss);
    v.group("gravity", gravity);
    v.group("odometry", odometry);
    v.group("information", information);
    v.group("mapping", mapping);
    v.group("occupancy", occupancy);
    v.group("loops", loops);
    v.group("retroactive", retroactive);
    v.group("backend", backend);
    v.group("localization", localization);
    v.group("background", background);
    v.group("live", live);
  }
};

/// The frame of the poses of the odometry in messages. Where the robot broadcasts an odometry of
/// its own, that is another frame.
inline std::string ownOdomFrame(const SlamConfig& config) {
  return config.frames.odom + (config.live.broadcast_odom ? "" : "_slam");
}

}  // namespace revisit_slam
