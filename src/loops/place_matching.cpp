// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/place_matching.h"

#include "revisit_slam/loops/place_nearest.h"

namespace revisit_slam {

std::vector<FeatureMatch> matchFeatures(const std::vector<Descriptor>& source,
                                        const std::vector<Descriptor>& target, int max_distance) {
  std::vector<FeatureMatch> matches;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NearestDescriptor best =
        nearestDescriptor(source[i], target.data(), 0, target.size(), max_distance + 1);
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
      return nearestDescriptor(descriptors[i], descriptors.data(), begin, end, max_distance + 1)
                 .distance <= max_distance;
    };
    repeated[i] = is_near(0, i) || is_near(i + 1, count);
  }
  return repeated;
}

}  // namespace revisit_slam
