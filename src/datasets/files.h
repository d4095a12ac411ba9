// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/datasets/dataset_scans.h"

namespace revisit_slam {

/// The first of `names` that exists below `folder`, as a path.
std::optional<std::string> findBelow(const std::string& folder,
                                     const std::vector<std::string>& names);
/// @throws DatasetError where none exists.
std::string requireBelow(const std::string& folder, const std::vector<std::string>& names);

struct NumberedFile {
  std::int64_t number = 0;
  std::string path;
};

/// The number in a file's name without its extension; nothing for files that are no scans.
using NumberInName = std::function<std::optional<std::int64_t>(const std::string& stem)>;
/// All digits: "000042", "1691936557946849179".
std::optional<std::int64_t> wholeNumber(const std::string& stem);

/// The files with that extension in the order of their numbers; others are left alone.
/// @throws DatasetError where there are none.
std::vector<NumberedFile> numberedFiles(const std::string& folder, const std::string& extension,
                                        const NumberInName& number = wholeNumber);

/// Scans whose number is their stamp in nanoseconds.
std::vector<ScanFile> scansByStamp(const std::vector<NumberedFile>& files);

/// The whole file. @throws DatasetError where it cannot be read, is empty, or is too large for a
/// scan.
std::vector<std::uint8_t> readBytes(const std::string& path);

}  // namespace revisit_slam
