// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>

#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// The smallest sector with all directions, seen from above, in degrees.
struct ViewSector {
  double middle = 0.0;  ///< counter-clockwise from the x axis, in [0, 360)
  double width = 0.0;
};

/// Degrees from one direction to another, in [-180, 180).
double turnBetween(double from, double to);

/// In which directions, seen from above, a message has points.
class ViewedDirections {
 public:
  void add(const Points& points);
  void add(const ViewedDirections& others) { degrees_ |= others.degrees_; }

  ViewSector sector() const;

 private:
  std::bitset<360> degrees_;
};

}  // namespace revisit_slam
