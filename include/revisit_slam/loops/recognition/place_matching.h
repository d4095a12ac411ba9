// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/loops/recognition/place_nearest.h"

namespace revisit_slam {

/// A feature of one map and the one of another map that looks most like it.
struct FeatureMatch {
  std::uint16_t source = 0;
  std::uint16_t target = 0;
};

/// For each source feature its nearest target feature, where they differ by at most `max_distance`
/// bits; of equally near ones the first. Exact.
std::vector<FeatureMatch> matchFeatures(const std::vector<Descriptor>& source,
                                        const DescriptorBlocks& target, int max_distance);

/// Whether each descriptor has another one of the same list within `max_distance` bits.
std::vector<bool> repeatedDescriptors(const std::vector<Descriptor>& descriptors, int max_distance);

}  // namespace revisit_slam
