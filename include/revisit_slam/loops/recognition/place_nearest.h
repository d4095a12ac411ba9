// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "revisit_slam/loops/recognition/place_descriptor.h"

namespace revisit_slam {

struct NearestDescriptor {
  std::size_t index = 0;
  int distance = 0;  ///< bits
};

/// Eight descriptors, word by word.
using DescriptorBlock =
    std::array<std::array<std::uint64_t, 8>, std::tuple_size<Descriptor>::value>;

/// The first of the nearest that are nearer than what it is given, else that.
using DescriptorSearch = NearestDescriptor(const Descriptor& query,
                                           const std::vector<DescriptorBlock>& blocks,
                                           NearestDescriptor otherwise);

/// The versions that this processor can run, the fastest last; all give the same.
const std::vector<DescriptorSearch*>& descriptorSearches();

/// Descriptors laid out so that a processor can compare eight of them with another one at a time.
class DescriptorBlocks {
 public:
  explicit DescriptorBlocks(const std::vector<Descriptor>& descriptors);

  void set(std::size_t index, const Descriptor& descriptor);
  std::size_t bytes() const { return blocks_.size() * sizeof(DescriptorBlock); }

  /// The first of the nearest that are nearer than `bound` bits, else {number of descriptors,
  /// bound}.
  NearestDescriptor nearest(const Descriptor& query, int bound,
                            DescriptorSearch* search = descriptorSearches().back()) const {
    return search(query, blocks_, {size_, bound});
  }

 private:
  std::size_t size_;
  std::vector<DescriptorBlock> blocks_;  ///< the last filled up with the last descriptor
};

}  // namespace revisit_slam
