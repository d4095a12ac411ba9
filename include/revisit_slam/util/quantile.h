// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace revisit_slam {

/// The smallest of the values that at least this share of them does not exceed.
/// @param values one or more  @param share 0 to 1
template <typename T>
T quantile(std::vector<T> values, double share) {
  const double rank = std::ceil(share * static_cast<double>(values.size())) - 1.0;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::max(0.0, rank));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace revisit_slam
