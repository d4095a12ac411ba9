// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Where a drive is in the map of an earlier one.
struct LocalizationConfig {
  std::string map;
  std::string start;
  double interval = 10.0;
  double open_length = 20.0;
  double window = 50.0;
  double search_interval = 10.0;
  double search_length = 100.0;
  double lost_after = 40.0;
  double min_overlap = 0.1;
  double deviation = 0.01;
  double rotation_deviation = 0.05;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("map", map, Choices{}, "",
      "folder of the session in whose map the drive is localized, and nothing is mapped; empty: a "
      "new map is made");
    v("start", start, Choices{}, "",
      "pose in the map at the first scan: x y yaw (m, rad), or x y z roll pitch yaw; empty: the "
      "place is recognised");
    v("interval", interval, Range{0.5, 1000.0}, "m",
      "travelled distance between two registrations to the map. Raise it to save CPU time; lower "
      "it if the odometry drifts noticeably in between");
    v("open_length", open_length, Range{1.0, 200.0}, "m",
      "travelled distance of the latest scans that are registered to the map together. Raise it if "
      "the sensor has few beams or a narrow view; lower it if the odometry bends what it adds up");
    v("window", window, Range{1.0, 10000.0}, "m",
      "travelled distance that the graph looks back over: its odometry edges and registrations "
      "give the pose. Raise it if the pose is unsteady; lower it if it follows the map too slowly");
    v("search_interval", search_interval, Range{0.5, 1000.0}, "m",
      "travelled distance between two attempts to recognise the place. Raise it to save CPU time; "
      "lower it if the first fix comes late");
    v("search_length", search_length, Range{10.0, 1000.0}, "m",
      "largest travelled distance of the latest scans by which a place is recognised. Raise it if "
      "places are recognised late; lower it if drift bends what is compared");
    v("lost_after", lost_after, Range{1.0, 10000.0}, "m",
      "travelled distance without a registration that passes the gates after which the pose counts "
      "as lost. Raise it if the map has long gaps; lower it if a pose must not be carried by the "
      "odometry alone");
    v("min_overlap", min_overlap, Range{0.0, 1.0}, "",
      "smallest fitness of a registration to the map, in the place of loops/min_fitness: smaller, "
      "as the last metres and a submap of the map may see very different amounts. Raise it if "
      "wrong places are taken; lower it if another sensor than the map's is not localized");
    v("deviation", deviation, Range{0.0, 10.0}, "m",
      "standard deviation of the position along each axis after a registration to the map, beside "
      "that of the registered points: both maps are bent. Raise it if the covariance of the "
      "pose is too small");
    v("rotation_deviation", rotation_deviation, Range{0.0, 10.0}, "deg",
      "standard deviation of the rotation about each axis after a registration to the map, "
      "likewise. Raise it if the covariance of the pose is too small");
  }
};

}  // namespace revisit_slam
