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
  std::string stamps = "header";
  std::string sweeps = "auto";
  double scan_period = 0.0;
  bool azimuth_clockwise = true;
  double azimuth_start = 180.0;
  std::string topics;
  std::string ranges;
  std::string time_offsets;
  double max_wait = 0.2;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("time_field", time_field, Choices{}, "",
      "field with the times of the points. auto: found by name and content; none: no deskewing; "
      "azimuth: times from the directions of the points of a spinning sensor; any other text: the "
      "name of the field");
    v("time_unit", time_unit, Choices{"auto", "s", "ms", "us", "ns"}, "",
      "unit of the time field; auto: found from the name, type and values of the field");
    v("time_origin", time_origin, Choices{"auto", "absolute", "relative"}, "",
      "where the times of the points count from. absolute: the epoch; relative: the header stamp; "
      "auto: found from the values");
    v("header_stamp", header_stamp, Choices{"auto", "first", "middle", "last"}, "",
      "point of the sweep that the header stamp belongs to (first, middle or last), for times "
      "that are not absolute; auto: the point of time zero, with time_field azimuth the last "
      "point");
    v("stamps", stamps, Choices{"header", "arrival"}, "",
      "time of a message. header: its header stamp; arrival: when it was received, for drivers "
      "that leave the header stamp zero: then the message came after its last point, and poses "
      "are as irregular in time as messages arrive");
    v("sweeps", sweeps, Choices{"auto", "messages"}, "",
      "what is registered as one scan. auto: sweeps are assembled from the messages where these "
      "hold a part of a revolution or come more often than 30 times a second; messages: every "
      "message is a scan");
    v("scan_period", scan_period, Range{0.0, 2.0}, "s",
      "duration of a sweep, for time_field azimuth and for sweeps that are assembled from "
      "messages; 0: estimated from the messages. Set it if header stamps are irregular");
    v("azimuth_clockwise", azimuth_clockwise,
      "direction of rotation seen from above, for time_field azimuth. true: clockwise; false: "
      "counter-clockwise");
    v("azimuth_start", azimuth_start, Range{-360.0, 360.0}, "deg",
      "direction in which a sweep starts, counter-clockwise from the x axis of the sensor, for "
      "time_field azimuth; 180: behind. Set it to where scans in motion have a seam");
    v("topics", topics, Choices{}, "",
      "topics of the scans of several sensors, separated by spaces, which are merged into one "
      "sweep, "
      "live "
      "and in bags; empty: one sensor, on the topic points");
    v("ranges", ranges, Choices{}, "",
      "shortest and longest range of each of input/topics, in their order, separated by spaces "
      "(m), "
      "within odometry/min_range and odometry/max_range; empty: these alone");
    v("time_offsets", time_offsets, Choices{}, "",
      "time that is added to the stamps of each of input/topics, in their order, separated by "
      "spaces "
      "(s); empty: none");
    v("max_wait", max_wait, Range{0.0, 10.0}, "s",
      "longest time, by stamps, for which a sweep waits for scans of the other input/topics; then "
      "it goes on without them. Raise it if scans of a sensor come late; lower it if poses come "
      "too late");
  }
};

}  // namespace revisit_slam
