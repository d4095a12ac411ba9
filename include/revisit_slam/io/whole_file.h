// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

namespace revisit_slam {

/// Lets `write` make a file under a temporary name beside `path`, hands it to the disk and renames
/// it: `path` is either the old file or the whole new one, also when the power fails.
/// @throws std::runtime_error naming the file.
void writeWholeFile(const std::string& path,
                    const std::function<void(const std::string& temporary)>& write);

/// Hands the finished file `temporary` to the disk and renames it to `path`.
/// @throws std::runtime_error naming `path`.
void replaceWholeFile(const std::string& temporary, const std::string& path);

/// writeWholeFile() for a text.
void writeWholeText(const std::string& path, const std::string& text);

}  // namespace revisit_slam
