// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace revisit_slam {

/// Whether an open file is the one of that name: the name may be gone, or that of another file.
bool hasName(int file, const std::string& path);

}  // namespace revisit_slam
