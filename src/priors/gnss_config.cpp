// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/gnss_config.h"

#include <cstdio>

#include "revisit_slam/geometry/local_enu.h"
#include "revisit_slam/util/number_list.h"

namespace revisit_slam {

std::optional<Eigen::Vector3d> GnssConfig::antennaInBase() const {
  const std::vector<double> numbers =
      numbersOf(antenna, 3, "gnss/antenna", "three numbers x y z (m), or empty");
  if (numbers.empty()) return std::nullopt;
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

std::optional<GeodeticPosition> GnssConfig::givenDatum() const {
  const std::string form = "latitude (-90 to 90) longitude (-360 to 360) altitude (m), or empty";
  const std::vector<double> numbers = numbersOf(datum, 3, "gnss/datum", form);
  if (numbers.empty()) return std::nullopt;
  const GeodeticPosition position{numbers[0], numbers[1], numbers[2]};
  if (!isValid(position))
    throw ParameterError("parameter 'gnss/datum' is '" + datum + "', not " + form);
  return position;
}

GnssConfig GnssConfig::withDatumOf(const std::optional<GeodeticPosition>& map) const {
  GnssConfig config = *this;
  if (!map || givenDatum()) return config;
  char text[128];
  std::snprintf(text, sizeof(text), "%.10f %.10f %.4f", map->latitude, map->longitude,
                map->altitude);
  config.datum = text;
  return config;
}

}  // namespace revisit_slam
