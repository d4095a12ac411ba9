// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_matching.h"

namespace revisit_slam {

std::vector<FeatureMatch> matchFeatures(const std::vector<Descriptor>& source,
                                        const DescriptorBlocks& target, int max_distance) {
  std::vector<FeatureMatch> matches;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NearestDescriptor best = target.nearest(source[i], max_distance + 1);
    if (best.distance > max_distance) continue;
    matches.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(best.index)});
  }
  return matches;
}

std::vector<bool> repeatedDescriptors(const std::vector<Descriptor>& descriptors,
                                      int max_distance) {
  std::vector<bool> repeated(descriptors.size());
  DescriptorBlocks others(descriptors);
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    const Descriptor& d = descriptors[i];
    others.set(i, {~d[0], ~d[1], ~d[2], ~d[3]});  // farthest from itself
    repeated[i] = others.nearest(d, max_distance + 1).distance <= max_distance;
    others.set(i, d);
  }
  return repeated;
}

}  // namespace revisit_slam
