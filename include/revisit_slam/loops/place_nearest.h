// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "revisit_slam/loops/place_descriptor.h"

namespace revisit_slam {

struct NearestDescriptor {
  std::size_t index = 0;
  int distance = 0;  ///< bits
};

/// Descriptors laid out so that a processor can compare eight of them with another one at a time.
class DescriptorBlocks {
 public:
  explicit DescriptorBlocks(const std::vector<Descriptor>& descriptors);

  std::size_t size() const { return size_; }
  void set(std::size_t index, const Descriptor& descriptor);

  /// The first of the nearest that are nearer than `bound` bits, else {size(), bound}. Runs the
  /// fastest version that the processor has; all give the same.
  NearestDescriptor nearest(const Descriptor& query, int bound) const;

  static constexpr std::size_t kLanes = 8;
  /// Word by word; the last block is filled up with its last descriptor.
  using Block = std::array<std::array<std::uint64_t, kLanes>, std::tuple_size<Descriptor>::value>;

 private:
  std::size_t size_;
  std::vector<Block> blocks_;
};

}  // namespace revisit_slam
