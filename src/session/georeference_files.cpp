// SPDX-License-Identifier: MIT
#include "revisit_slam/session/georeference_files.h"

#include <cstdio>
#include <optional>
#include <sstream>

#include "revisit_slam/geometry/local_enu.h"
#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {
namespace {

template <typename... Zone>
std::optional<UtmPosition> utmOf(const GeodeticPosition& position, const Zone&... zone) {
  try {
    return toUtm(position, zone...);
  } catch (const std::exception&) {
    return std::nullopt;  // near the poles, or far from the zone
  }
}

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  char text[512];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

std::string describe(const Georeference& georeference) {
  const GeodeticPosition& datum = georeference.datum;
  const auto& [q, t] = georeference.T_enu_map;
  std::ostringstream yaml;
  yaml << formatted("datum: {latitude: %.10f, longitude: %.10f, altitude: %.4f}\n", datum.latitude,
                    datum.longitude, datum.altitude)
       << formatted(
              "T_enu_map: {x: %.6f, y: %.6f, z: %.6f, qx: %.9f, qy: %.9f, qz: %.9f, qw: %.9f}\n",
              t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  if (const std::optional<UtmPosition> utm = utmOf(datum))
    yaml << formatted("utm: {zone: %d, north: %s, epsg: %d, easting: %.4f, northing: %.4f}\n",
                      utm->zone, utm->north ? "true" : "false", utm->epsg(), utm->easting,
                      utm->northing);
  yaml << formatted("yaw_deviation: %.6f\n", georeference.yaw_deviation)
       << "positions: " << georeference.fixes << "\n"
       << "outliers: " << georeference.outliers << "\n";
  return yaml.str();
}

std::string tableOf(const Trajectory& trajectory_enu, const LocalEnu& enu) {
  const std::optional<UtmPosition> origin = utmOf(enu.datum());
  std::ostringstream table;
  table << "stamp,latitude,longitude,altitude,easting,northing\n";
  for (const StampedPose& pose : trajectory_enu) {
    const GeodeticPosition position = enu.toGeodetic(pose.T_world_base.translation);
    table << stampText(pose.stamp)
          << formatted(",%.10f,%.10f,%.4f,", position.latitude, position.longitude,
                       position.altitude);
    if (const auto utm = origin ? utmOf(position, *origin) : std::nullopt)
      table << formatted("%.4f,%.4f", utm->easting, utm->northing);
    else
      table << ",";
    table << "\n";
  }
  return table.str();
}

}  // namespace

void writeGeoreference(const std::string& folder, const Trajectory& trajectory_map,
                       const Georeference& georeference) {
  Trajectory trajectory_enu = trajectory_map;
  for (StampedPose& pose : trajectory_enu)
    pose.T_world_base = georeference.T_enu_map * pose.T_world_base;
  writeWholeText(folder + "/georeference.yaml", describe(georeference));
  writeTum(folder + "/trajectory_enu.tum", trajectory_enu);
  writeWholeText(folder + "/trajectory_utm.csv",
                 tableOf(trajectory_enu, LocalEnu(georeference.datum)));
}

}  // namespace revisit_slam
