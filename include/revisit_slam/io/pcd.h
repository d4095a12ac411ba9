// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <fstream>
#include <string>

#include "revisit_slam/io/cloud_file.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Writes a binary PCD file with fields x y z, and intensity where there are intensities, whole or
/// not at all.
/// @throws std::runtime_error naming the file, or when there are no points.
void writePcd(const std::string& path, const Points& points,
              const std::vector<float>& intensities = {});

/// Reads the points of what this project writes. @throws std::runtime_error naming a file that is
/// damaged, or of another layout.
Points readPcdPoints(const std::string& path);

/// A binary PCD file with fields x y z, and intensity if asked for, written piece by piece, in
/// whatever memory one piece takes.
class PcdStream final : public CloudStream {
 public:
  explicit PcdStream(const std::string& path, bool with_intensities = false);
  void write(const Points& points, const std::vector<float>& intensities) override;
  void finish() override;
  std::size_t size() const { return count_; }

 private:
  void writeHeader();

  std::string path_;
  const bool with_intensities_;
  std::ofstream file_;
  std::size_t count_ = 0;
};

}  // namespace revisit_slam
