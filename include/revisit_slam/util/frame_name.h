// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace revisit_slam {

/// A name of a frame as tf2 knows it: the predecessor of tf2 wrote them with a slash in front, and
/// drivers of that time still do.
inline std::string withoutLeadingSlash(const std::string& frame) {
  return frame.substr(frame.find('/') == 0 ? 1 : 0);
}

}  // namespace revisit_slam
