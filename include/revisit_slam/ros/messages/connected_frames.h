// SPDX-License-Identifier: MIT
#pragma once

#include <tf2/buffer_core.h>

#include <string>
#include <vector>

namespace revisit_slam {

/// Other frames to which there is a transform from this one, by name.
std::vector<std::string> framesConnectedWith(const std::string& frame,
                                             const tf2::BufferCore& transforms);

/// "a, b, c"
std::string listOf(const std::vector<std::string>& words);

}  // namespace revisit_slam
