// SPDX-License-Identifier: MIT
#include "revisit_slam/session/map_frame.h"

#include <cmath>
#include <stdexcept>

#include "revisit_slam/geometry/local_enu.h"

namespace revisit_slam {
namespace {

constexpr double kOriginStep = 1000.0;  // m

CloudFrame utmFrame(const Georeference& georeference, const std::optional<int>& zone) {
  const LocalEnu enu(georeference.datum);
  UtmPosition datum = toUtm(georeference.datum);
  if (zone) {
    datum.zone = *zone;
    datum = toUtm(georeference.datum, datum);
  }
  CloudFrame frame;
  frame.place = [enu, datum, T_enu_map = georeference.T_enu_map](const Eigen::Vector3d& p_map) {
    const GeodeticPosition position = enu.toGeodetic(T_enu_map * p_map);
    const UtmPosition utm = toUtm(position, datum);
    return Eigen::Vector3d(utm.easting, utm.northing, position.altitude);
  };
  frame.origin = {kOriginStep * std::floor(datum.easting / kOriginStep),
                  kOriginStep * std::floor(datum.northing / kOriginStep), 0.0};
  frame.epsg = datum.epsg();
  return frame;
}

}  // namespace

MapFrame::Kind mapFrameKind(const std::string& name) {
  if (name == "map") return MapFrame::Kind::map;
  if (name == "enu") return MapFrame::Kind::enu;
  if (name == "utm") return MapFrame::Kind::utm;
  throw std::invalid_argument("'" + name + "' is no frame of a map: map, enu, utm");
}

CloudFrame cloudFrameOf(const MapFrame& frame, const std::optional<Georeference>& georeference,
                        const std::string& format) {
  if (frame.kind == MapFrame::Kind::map) return {};
  if (!georeference)
    throw std::invalid_argument(
        "the session has no georeference: only a map with GNSS can be exported in enu or utm");
  if (frame.kind == MapFrame::Kind::enu) {
    CloudFrame enu;
    enu.place = [T_enu_map = georeference->T_enu_map](const Eigen::Vector3d& p_map) {
      return Eigen::Vector3d(T_enu_map * p_map);
    };
    return enu;
  }
  if (format != "las")
    throw std::invalid_argument(format +
                                " has single precision, half a metre in UTM: export las, or enu");
  try {
    return utmFrame(*georeference, frame.utm_zone);
  } catch (const std::exception& error) {  // of GeographicLib
    throw std::invalid_argument(std::string("the map cannot be placed in this zone of UTM: ") +
                                error.what());
  }
}

}  // namespace revisit_slam
