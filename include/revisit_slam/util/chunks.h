// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace revisit_slam {

/// Indices [begin, end).
struct Chunk {
  std::size_t begin, end;
};

/// Cuts indices 0 … count-1 into chunks of one fixed length. Work that is summed per chunk and then
/// over the chunks in order gives the same bits for any number of threads.
class Chunks {
 public:
  Chunks(std::size_t count, std::size_t length) : count_(count), length_(length) {}

  std::size_t size() const { return (count_ + length_ - 1) / length_; }
  Chunk operator[](std::size_t index) const {
    return {index * length_, std::min(count_, (index + 1) * length_)};
  }

  /// Calls work(index, chunk) for every chunk, in parallel in the current TBB arena.
  template <typename Work>
  void forEach(const Work& work) const {
    tbb::parallel_for(std::size_t{0}, size(),
                      [&](std::size_t index) { work(index, (*this)[index]); });
  }

 private:
  std::size_t count_;
  std::size_t length_;
};

}  // namespace revisit_slam
