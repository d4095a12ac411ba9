// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/local_enu.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace revisit_slam {
namespace {

using GeographicLib::UTMUPS;

constexpr double kFalseNorthing = 1e7;  // m, of the equator, seen from the south

UtmPosition inZone(const GeodeticPosition& position, int zone) {
  UtmPosition utm;
  UTMUPS::Forward(position.latitude, position.longitude, utm.zone, utm.north, utm.easting,
                  utm.northing, zone);
  if (utm.zone == 0) throw std::runtime_error("there is no zone of UTM near the poles");
  return utm;
}

const GeographicLib::Geocentric& wgs84() {
  return GeographicLib::Geocentric::WGS84();
}

}  // namespace

LocalEnu::LocalEnu(const GeodeticPosition& datum) : datum_(datum) {
  std::vector<double> axes(9);  // row by row: of enu in ecef
  Eigen::Vector3d& t = T_ecef_enu_.translation;
  wgs84().Forward(datum.latitude, datum.longitude, datum.altitude, t.x(), t.y(), t.z(), axes);
  const Eigen::Matrix3d R =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(axes.data());
  T_ecef_enu_.rotation = Eigen::Quaterniond(R).normalized();
}

Eigen::Vector3d LocalEnu::toEnu(const GeodeticPosition& position) const {
  Eigen::Vector3d p_ecef;
  wgs84().Forward(position.latitude, position.longitude, position.altitude, p_ecef.x(), p_ecef.y(),
                  p_ecef.z());
  return T_ecef_enu_.rotation.conjugate() * (p_ecef - T_ecef_enu_.translation);
}

GeodeticPosition LocalEnu::toGeodetic(const Eigen::Vector3d& p_enu) const {
  const Eigen::Vector3d p_ecef = T_ecef_enu_ * p_enu;
  GeodeticPosition position;
  wgs84().Reverse(p_ecef.x(), p_ecef.y(), p_ecef.z(), position.latitude, position.longitude,
                  position.altitude);
  return position;
}

UtmPosition toUtm(const GeodeticPosition& position) {
  return inZone(position, static_cast<int>(UTMUPS::STANDARD));
}

UtmPosition toUtm(const GeodeticPosition& position, const UtmPosition& other) {
  UtmPosition utm = inZone(position, other.zone);
  if (utm.north != other.north) utm.northing += other.north ? -kFalseNorthing : kFalseNorthing;
  utm.north = other.north;
  return utm;
}

bool isValid(const GeodeticPosition& position) {
  return std::isfinite(position.altitude) && std::abs(position.altitude) < 1e5 &&
         std::abs(position.latitude) <= 90.0 && std::abs(position.longitude) <= 360.0;
}

}  // namespace revisit_slam
