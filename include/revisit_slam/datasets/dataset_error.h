// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace revisit_slam {

/// A file or folder of a dataset that cannot be used; the message starts with its path.
class DatasetError : public std::runtime_error {
 public:
  DatasetError(const std::string& path, const std::string& what)
      : std::runtime_error("'" + path + "': " + what) {}
};

}  // namespace revisit_slam
