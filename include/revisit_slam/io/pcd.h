// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/core/scan.h"

namespace revisit_slam {

/// Writes a binary PCD file with fields x y z, under a temporary name that becomes `path` when it is
/// whole. @throws std::runtime_error naming the file, or when there are no points.
void writePcd(const std::string& path, const Points& points);

}  // namespace revisit_slam
