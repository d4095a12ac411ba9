// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <numeric>

namespace revisit_slam {

/// Visits 0 … count-1 once each in steps of the golden section, which spreads any first few of them
/// evenly over all.
class SpreadOrder {
 public:
  explicit SpreadOrder(std::size_t count) : count_(count) {
    if (count < 2) return;
    step_ = static_cast<std::size_t>(0.6180339887498949 * static_cast<double>(count)) | 1;
    while (std::gcd(step_, count) != 1) ++step_;
  }

  std::size_t next() {
    const std::size_t index = index_;
    index_ += step_;
    if (index_ >= count_) index_ -= count_;
    return index;
  }

 private:
  std::size_t count_;
  std::size_t step_ = 1;
  std::size_t index_ = 0;
};

}  // namespace revisit_slam
