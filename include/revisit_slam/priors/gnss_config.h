// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "revisit_slam/types/geodetic_position.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Positions by GNSS. Off where no topic is named.
struct GnssConfig {
  std::string topic;
  std::string antenna;
  std::string datum;
  double time_offset = 0.0;
  double max_delay = 1.0;
  double spacing = 2.0;
  double unknown_deviation = 5.0;
  double min_deviation = 0.1;
  double kernel_scale = 4.0;
  double alignment_deviation = 0.05;
  double start_tilt = 0.1;

  bool isConnected() const { return !topic.empty(); }
  /// Nothing where the parameter is empty. @throws ParameterError
  std::optional<Eigen::Vector3d> antennaInBase() const;
  std::optional<GeodeticPosition> givenDatum() const;

  /// Where none is given, with the one of the map that a session goes on from.
  GnssConfig withDatumOf(const std::optional<GeodeticPosition>& map) const;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("topic", topic, Choices{}, "",
      "topic of the positions of a GNSS receiver, sensor_msgs/NavSatFix, live and in bags; empty: "
      "none");
    v("antenna", antenna, Choices{}, "",
      "position of the antenna in the base frame, x y z (m); empty: that of the message's "
      "frame_id, "
      "by TF");
    v("datum", datum, Choices{}, "",
      "origin of the frame of east, north and up: latitude longitude (deg) altitude (m above the "
      "ellipsoid); empty: the first position that is used");
    v("time_offset", time_offset, Range{-10.0, 10.0}, "s",
      "time that is added to the stamps of positions. Raise it if positions are stamped too early; "
      "lower it if they are stamped when they arrive");
    v("max_delay", max_delay, Range{0.05, 30.0}, "s",
      "delay after which a position enters the graph; positions that arrive later than that "
      "are dropped. Raise it if positions are dropped as too late; lower it if they should "
      "enter sooner");
    v("spacing", spacing, Range{0.0, 100.0}, "m",
      "shortest distance between two positions in a row that are used. Raise it if optimisations "
      "take long, or where errors of neighbouring positions are alike; lower it if the receiver "
      "is noisy");
    v("unknown_deviation", unknown_deviation, Range{0.001, 1000.0}, "m",
      "horizontal standard deviation of positions whose messages have no covariance; twice as much "
      "vertically. Raise it among high buildings; lower it under open sky");
    v("min_deviation", min_deviation, Range{0.001, 100.0}, "m",
      "smallest standard deviation of a position, whatever its message says. Raise it if stamps of "
      "positions are unsure or the receiver is too sure of itself; lower it for a surveyed one");
    v("kernel_scale", kernel_scale, Range{0.1, 1000.0}, "",
      "scale of the robust kernel (geman_mcclure) of positions, in standard deviations. Raise it "
      "if "
      "good positions are outliers; lower it if multipath bends the map");
    v("alignment_deviation", alignment_deviation, Range{0.001, 1.0}, "rad",
      "standard deviation of the map's yaw, as the positions give it, below which the map is "
      "aligned with east and north and positions enter the graph. Raise it to align sooner; lower "
      "it if multipath at the start turns the map");
    v("start_tilt", start_tilt, Range{0.001, 3.2}, "rad",
      "standard deviation of the tilt of the base at the first scan. Raise it for starts on slopes "
      "and in the hand; lower it for level yards");
  }
};

}  // namespace revisit_slam
