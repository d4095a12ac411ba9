// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace revisit_slam {

/// What was found out about a part of the input, and what to do about it.
struct Finding {
  enum class Level { good, hint, warning, fault };

  Level level = Level::good;
  std::string part;  ///< "point times"
  std::string text;
  std::string remedy;  ///< empty: nothing to do
};

}  // namespace revisit_slam
