// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/input/point_view.h"
#include "revisit_slam/input/scan_reading.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// The points of a message that are measurements: finite and not the origin.
struct KeptPoints {
  Points points;
  /// Where each of them begins in the bytes of the message.
  std::vector<std::uint32_t> byte_offsets;
  PointCounts counts;
};

/// The view has passed layoutFault() and has x, y and z of known type.
KeptPoints readPoints(const PointView& view);

/// The value of one field for each of these points.
std::vector<double> readField(const PointView& view, const PointField& field,
                              const std::vector<std::uint32_t>& byte_offsets);

/// Of each of these points, 0 where it is not finite: field `intensity`, or `reflectivity` as Livox
/// and others call it. Empty where there is neither.
std::vector<float> readIntensities(const PointView& view,
                                   const std::vector<std::uint32_t>& byte_offsets);

}  // namespace revisit_slam
