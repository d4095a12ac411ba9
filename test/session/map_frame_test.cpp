// SPDX-License-Identifier: MIT
#include "revisit_slam/session/map_frame.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "revisit_slam/geometry/local_enu.h"

namespace revisit_slam {
namespace {

/// Turned by a quarter: what is ahead in the map is north.
Georeference georeference(const GeodeticPosition& datum) {
  Georeference georeference;
  georeference.datum = datum;
  georeference.T_enu_map = {
      Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ())), {10.0, 20.0, 5.0}};
  return georeference;
}

const GeodeticPosition kMunich{48.1, 11.6, 520.0}, kSydney{-33.9, 151.2, 30.0};
const MapFrame kEnu{MapFrame::Kind::enu, {}}, kUtm{MapFrame::Kind::utm, {}};

TEST(MapFrame, TheMapStaysWhereItIs) {
  EXPECT_FALSE(cloudFrameOf({}, georeference(kMunich), "pcd").place);
  EXPECT_FALSE(cloudFrameOf({}, std::nullopt, "las").place);
}

TEST(MapFrame, EnuIsEastNorthAndUpAtTheDatum) {
  const CloudFrame frame = cloudFrameOf(kEnu, georeference(kMunich), "pcd");
  EXPECT_LT((frame.place({3.0, 0.0, 1.0}) - Eigen::Vector3d(10.0, 23.0, 6.0)).norm(), 1e-9);
  EXPECT_EQ(frame.epsg, 0);
}

/// Against a conversion of the same place from the earth's side.
TEST(MapFrame, UtmIsWhereThePlaceIsOnTheEarth) {
  for (const auto& [datum, epsg] : {std::pair(kMunich, 32632), std::pair(kSydney, 32756)}) {
    const CloudFrame frame = cloudFrameOf(kUtm, georeference(datum), "las");
    EXPECT_EQ(frame.epsg, epsg);
    // 0.01 degrees of latitude are 1112 m and less than that along the chord.
    const GeodeticPosition north{datum.latitude + 0.01, datum.longitude, datum.altitude + 7.0};
    const Eigen::Vector3d p_map =
        georeference(datum).T_enu_map.inverse() * LocalEnu(datum).toEnu(north);
    const UtmPosition utm = toUtm(north);
    EXPECT_LT(
        (frame.place(p_map) - Eigen::Vector3d(utm.easting, utm.northing, north.altitude)).norm(),
        1e-6);
    EXPECT_LT((frame.place(p_map) - frame.origin).head<2>().norm(), 3000.0);
  }
}

TEST(MapFrame, AZoneCanBeGiven) {
  const MapFrame neighbour{MapFrame::Kind::utm, 33};
  const CloudFrame frame = cloudFrameOf(neighbour, georeference(kMunich), "las");
  EXPECT_EQ(frame.epsg, 32633);
  EXPECT_LT(frame.place(Eigen::Vector3d::Zero()).x(), 300000.0);  // west of its meridian
  EXPECT_THROW(cloudFrameOf({MapFrame::Kind::utm, 60}, georeference(kMunich), "las"),
               std::invalid_argument);
}

TEST(MapFrame, WhatCannotBeIsRefused) {
  EXPECT_THROW(cloudFrameOf(kEnu, std::nullopt, "las"), std::invalid_argument);
  EXPECT_THROW(cloudFrameOf(kUtm, georeference(kMunich), "pcd"), std::invalid_argument);
  EXPECT_THROW(cloudFrameOf(kUtm, georeference({89.0, 0.0, 0.0}), "las"), std::invalid_argument);
  EXPECT_THROW(mapFrameKind("ecef"), std::invalid_argument);
}

}  // namespace
}  // namespace revisit_slam
