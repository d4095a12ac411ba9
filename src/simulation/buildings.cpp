// SPDX-License-Identifier: MIT
#include "buildings.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam::simulation {
namespace {

constexpr double kHalfPi = 1.5707963267948966;

class HouseRow {
 public:
  HouseRow(Site& site, const BuildingStyle& style, Random& random)
      : site_(site), style_(style), random_(random) {}

  void build(const Road& road, double side) {
    const Polyline line = resampled(road.middle, 1.0);
    const double length = static_cast<double>(line.size());
    double set_back = setBack();
    for (double arc = random_.uniform(0.0, 6.0); arc < length;) {
      const double width = random_.uniform(style_.narrowest, style_.widest);
      const auto middle = static_cast<std::size_t>(arc + 0.5 * width);
      if (middle >= line.size()) return;
      if (random_.chance(0.4)) set_back = setBack();
      if (tryHouse(road, line, middle, side, width, set_back)) {
        arc += width + gap();
      } else {
        arc += 2.0;
      }
    }
  }

 private:
  double setBack() { return random_.uniform(style_.nearest, style_.farthest); }
  double gap() {
    return random_.chance(style_.gap_share) ? random_.uniform(3.0, 14.0)
                                            : random_.uniform(0.05, 1.5);
  }

  bool tryHouse(const Road& road, const Polyline& line, std::size_t index, double side,
                double width, double set_back) {
    const double depth = random_.uniform(style_.shallowest, style_.deepest);
    const Eigen::Vector2d along = directionAt(line, index);
    const Eigen::Vector2d aside = side * Eigen::Vector2d(-along.y(), along.x());
    const double reach = road.half_width + set_back + 0.5 * depth;
    const Eigen::Vector2d centre = line[index].head<2>() + reach * aside;
    const double yaw = std::atan2(aside.y(), aside.x()) - kHalfPi;
    Plot plot{{{centre.x(), centre.y(), 0.0}, yaw}, 0.5 * width, 0.5 * depth};
    if (!site_.isFree(plot, std::min(style_.nearest - 0.4, set_back - 0.2))) return false;
    site_.occupy(plot);
    plot.centre.origin.z() = lowestGround(plot) + 0.15;
    const int storeys = random_.integer(1, style_.highest_storeys);
    addHouse(site_.mesh(), plot, storeys * 3.0 + random_.uniform(0.0, 1.0), random_);
    return true;
  }

  double lowestGround(const Plot& plot) const {
    double mean = 0.0;
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-1.0, 1.0}) {
        mean += 0.25 * site_.ground(plot.centre.flat(a * plot.half_length, b * plot.half_width));
      }
    }
    return mean;
  }

  Site& site_;
  const BuildingStyle& style_;
  Random& random_;
};

void addSecondRow(Site& site, Random& random) {
  const Neighbourhood& near = site.neighbourhood();
  const Eigen::Vector2d size = near.high() - near.low();
  const int tries = static_cast<int>(size.prod() / 500.0);
  for (int k = 0; k < tries; ++k) {
    const Eigen::Vector2d p =
        near.low() + Eigen::Vector2d(random.uniform(0.0, size.x()), random.uniform(0.0, size.y()));
    Plot plot{{{p.x(), p.y(), 0.0}, random.uniform(-0.3, 0.3)},
              random.uniform(1.5, 7.0),
              random.uniform(1.5, 5.0)};
    if (!site.isFree(plot, 8.0)) continue;
    site.occupy(plot);
    plot.centre.origin.z() = site.ground(p);
    addHouse(site.mesh(), plot, random.integer(1, 2) * 2.8, random);
  }
}

}  // namespace

void addBuildings(Site& site, const BuildingStyle& style) {
  Random random(hashOf(site.layout().seed, 930));
  HouseRow row(site, style, random);
  for (const Road& road : site.roads()) {
    for (const double side : {-1.0, 1.0}) row.build(road, side);
  }
  addSecondRow(site, random);
}

}  // namespace revisit_slam::simulation
