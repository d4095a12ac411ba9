// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/geometry/voxel_set.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Down-samples clouds to the first point of each voxel, in the order of the input. Keeps its
/// memory between calls, so that a call allocates nothing once the largest cloud has been seen.
class VoxelFilter {
 public:
  using Indices = std::vector<std::uint32_t>;

  /// Returns which points of the input the output consists of, until the next call.
  /// `voxel_size` in metres.
  const Indices& filter(const Points& input, double voxel_size, Points& output);

  /// The same with the input taken in a spread order. The first point of a voxel in the order of
  /// the scan lies on the side from which the sensor turned, and what is registered by such points
  /// is drawn to that side; in the spread order it may lie anywhere.
  const Indices& filterSpread(const Points& input, double voxel_size, Points& output);

  /// The first point of each voxel in the order of the input, handed on in the order of a hash
  /// table of the voxels: KISS-ICP's own, whose results depend on it where what is down-sampled
  /// is down-sampled again.
  const Indices& filterHashed(const Points& input, double voxel_size, Points& output);

 private:
  template <typename NextIndex>
  const Indices& filterInOrder(const Points& input, double voxel_size, Points& output,
                               NextIndex next);

  VoxelSet seen_;
  Indices kept_;
};

}  // namespace revisit_slam
