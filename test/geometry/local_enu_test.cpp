// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/local_enu.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace revisit_slam {
namespace {

const GeodeticPosition kDatum{48.1, 11.6, 520.0};

TEST(LocalEnu, AxesPointEastNorthAndUp) {
  const LocalEnu enu(kDatum);
  EXPECT_LT(enu.toEnu(kDatum).norm(), 1e-6);
  const Eigen::Vector3d east = enu.toEnu({48.1, 11.601, 520.0});
  EXPECT_NEAR(east.x(), 74.5, 0.1);  // m in 0.001 deg of longitude at this latitude
  EXPECT_NEAR(east.y(), 0.0, 0.01);
  const Eigen::Vector3d north = enu.toEnu({48.101, 11.6, 520.0});
  EXPECT_NEAR(north.y(), 111.2, 0.1);
  const Eigen::Vector3d up = enu.toEnu({48.1, 11.6, 530.0});
  EXPECT_LT((up - Eigen::Vector3d(0.0, 0.0, 10.0)).norm(), 1e-6);
}

TEST(LocalEnu, BackToTheEllipsoid) {
  const LocalEnu enu(kDatum);
  const Eigen::Vector3d p_enu(1234.5, -678.9, 12.3);
  EXPECT_LT((enu.toEnu(enu.toGeodetic(p_enu)) - p_enu).norm(), 1e-6);
}

TEST(LocalEnu, TheEarthsCentreIsBelow) {
  const Pose T_ecef_enu = LocalEnu(kDatum).T_ecef_enu();
  EXPECT_NEAR(T_ecef_enu.translation.norm(), 6.367e6, 1e4);
  const Eigen::Vector3d up = T_ecef_enu.rotation * Eigen::Vector3d::UnitZ();
  EXPECT_GT(up.dot(T_ecef_enu.translation.normalized()), 0.9999);
}

/// By the figures of the EPSG registry's method: the central meridian of zone 32 is at 9 degrees.
TEST(Utm, ZonesAreThoseOfEpsg) {
  const UtmPosition utm = toUtm({48.0, 9.0, 0.0});
  EXPECT_EQ(utm.zone, 32);
  EXPECT_EQ(utm.epsg(), 32632);
  EXPECT_NEAR(utm.easting, 500000.0, 1e-6);
  EXPECT_NEAR(utm.northing, 5316300.0, 400.0);
  EXPECT_EQ(toUtm({-33.0, 151.0, 0.0}).epsg(), 32756);
  EXPECT_EQ(toUtm({48.0, 12.01, 0.0}, utm).zone, 32);
  EXPECT_THROW(toUtm({89.0, 0.0, 0.0}), std::runtime_error);
}

TEST(Utm, NorthingsGoOnAcrossTheEquator) {
  for (const double side : {1.0, -1.0}) {
    const UtmPosition datum = toUtm({side * 0.0005, 9.0, 0.0});
    const UtmPosition across = toUtm({-side * 0.0005, 9.0, 0.0}, datum);
    EXPECT_EQ(across.epsg(), datum.epsg());
    EXPECT_NEAR(datum.northing - across.northing, side * 110.6, 0.5);  // m, of 0.001 degrees
  }
}

TEST(GeodeticPosition, NumbersThatAreNoPositionAreToldApart) {
  EXPECT_TRUE(isValid(kDatum));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isValid({nan, 0.0, 0.0}));
  EXPECT_FALSE(isValid({91.0, 0.0, 0.0}));
  EXPECT_FALSE(isValid({0.0, 0.0, nan}));
}

}  // namespace
}  // namespace revisit_slam
