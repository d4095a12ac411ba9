// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/place_matching.h"

namespace revisit_slam {
namespace {

struct Nearest {
  std::size_t index = 0;
  int distance = 0;
};

/// The nearest of `descriptors[begin, end)` that is nearer than `bound` bits, else the bound.
/// Stopping after half of the bits does not pay: a third of all pairs is still within the bound.
REVISIT_SLAM_COUNTS_BITS
Nearest nearest(const Descriptor& query, const Descriptor* descriptors, std::size_t begin,
                std::size_t end, int bound) {
  Nearest best{end, bound};
  for (std::size_t i = begin; i < end; ++i) {
    const int distance = differingBits(query, descriptors[i]);
    if (distance < best.distance) best = {i, distance};
  }
  return best;
}

}  // namespace

std::vector<FeatureMatch> matchFeatures(const std::vector<Descriptor>& source,
                                        const std::vector<Descriptor>& target, int max_distance) {
  std::vector<FeatureMatch> matches;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Nearest best = nearest(source[i], target.data(), 0, target.size(), max_distance + 1);
    if (best.distance > max_distance) continue;
    matches.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(best.index)});
  }
  return matches;
}

std::vector<bool> repeatedDescriptors(const std::vector<Descriptor>& descriptors,
                                      int max_distance) {
  const std::size_t count = descriptors.size();
  std::vector<bool> repeated(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto is_near = [&](std::size_t begin, std::size_t end) {
      return nearest(descriptors[i], descriptors.data(), begin, end, max_distance + 1).distance <=
             max_distance;
    };
    repeated[i] = is_near(0, i) || is_near(i + 1, count);
  }
  return repeated;
}

}  // namespace revisit_slam
