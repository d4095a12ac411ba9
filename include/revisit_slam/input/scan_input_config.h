// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// How the times of the points are found. With the defaults everything is decided from the data;
/// a value given here is kept even where the data look otherwise, unless they rule it out.
struct ScanInputConfig {
  std::string time_field = "auto";
  std::string time_unit = "auto";
  std::string time_origin = "auto";
  std::string header_stamp = "auto";
  double scan_period = 0.0;
  bool azimuth_clockwise = true;
  double azimuth_start = 180.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("time_field", time_field, Choices{}, "",
      "auto: by name and content; none: no deskewing; azimuth: from the direction of the points of "
      "a spinning sensor; else the name of the field");
    v("time_unit", time_unit, Choices{"auto", "s", "ms", "us", "ns"}, "", "unit of the time field");
    v("time_origin", time_origin, Choices{"auto", "absolute", "relative"}, "",
      "absolute: since the epoch; relative: since the header stamp");
    v("header_stamp", header_stamp, Choices{"auto", "first", "middle", "last"}, "",
      "which point of the sweep the header stamp belongs to, for times that are not absolute; "
      "auto: "
      "the point of time zero, with azimuth the last point");
    v("scan_period", scan_period, Range{0.0, 2.0}, "s",
      "duration of a sweep, for azimuth; 0: estimated from the header stamps");
    v("azimuth_clockwise", azimuth_clockwise, "the sensor turns clockwise seen from above");
    v("azimuth_start", azimuth_start, Range{-360.0, 360.0}, "deg",
      "where a sweep starts, counter-clockwise from the sensor's x axis; 180: behind");
  }
};

}  // namespace revisit_slam
