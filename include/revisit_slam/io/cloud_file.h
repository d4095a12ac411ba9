// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// A cloud that is written piece by piece, in whatever memory one piece takes.
class CloudStream {
 public:
  virtual ~CloudStream() = default;

  virtual void write(const Points& points) = 0;
  /// Puts into the header what is known at the end. @throws std::runtime_error naming the file.
  virtual void finish() = 0;
};

/// `format`: pcd (binary), ply (binary) or las (1.2, to the millimetre).
/// @throws std::invalid_argument for another one, std::runtime_error naming a file.
std::unique_ptr<CloudStream> makeCloudStream(const std::string& format, const std::string& path);

/// @throws std::invalid_argument for a format that makeCloudStream() does not write.
void requireCloudFormat(const std::string& format);

}  // namespace revisit_slam
