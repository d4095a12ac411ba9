// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/geodetic_position.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// The frame enu of a datum: x east, y north, z up, origin at the datum. Straight axes: 1 km away
/// the ground is 8 cm below its plane. WGS84; frame ecef: the earth's centre, as frame `earth` of
/// REP 105.
class LocalEnu {
 public:
  explicit LocalEnu(const GeodeticPosition& datum);

  const GeodeticPosition& datum() const { return datum_; }
  Eigen::Vector3d toEnu(const GeodeticPosition& position) const;
  GeodeticPosition toGeodetic(const Eigen::Vector3d& p_enu) const;
  const Pose& T_ecef_enu() const { return T_ecef_enu_; }

 private:
  GeodeticPosition datum_;
  Pose T_ecef_enu_;
};

/// In a zone of UTM, m.
struct UtmPosition {
  int zone = 0;
  bool north = true;
  double easting = 0.0, northing = 0.0;

  /// Of WGS 84 / UTM, EPSG.
  int epsg() const { return (north ? 32600 : 32700) + zone; }
};
/// In the zone of the position itself. @throws std::runtime_error near the poles.
UtmPosition toUtm(const GeodeticPosition& position);
/// In the zone and on the side of the equator of another one: northings go on across it. @throws
/// std::runtime_error near the poles and far from the zone.
UtmPosition toUtm(const GeodeticPosition& position, const UtmPosition& other);

/// Whether the numbers are a position on the earth.
bool isValid(const GeodeticPosition& position);

}  // namespace revisit_slam
