// SPDX-License-Identifier: MIT
#pragma once

#include "shapes.h"

namespace revisit_slam::simulation {

struct CarSize {
  double length;
  double width;
  double height;
};

int carModelCount();
CarSize carSize(int model);

/// A car on the ground, x forward, the origin below its middle.
void addCar(TriangleMesh& mesh, const Placement& at, int model);

}  // namespace revisit_slam::simulation
