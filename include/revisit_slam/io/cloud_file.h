// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// A cloud that is written piece by piece, in whatever memory one piece takes.
class CloudStream {
 public:
  virtual ~CloudStream() = default;

  /// `intensities`: one for each point, or none, which is 0 for each; of a stream without them they
  /// are left out.
  virtual void write(const Points& points, const std::vector<float>& intensities) = 0;
  /// Puts into the header what is known at the end. @throws std::runtime_error naming the file.
  virtual void finish() = 0;
};

/// The frame of the points of a file, if it is another one than that of the points written to it.
struct CloudFrame {
  /// From the frame of the points written, m; none: both are the same.
  std::function<Eigen::Vector3d(const Eigen::Vector3d& point)> place;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m, near the points
  int epsg = 0;  ///< of the projected coordinate reference system that this frame is; 0: of none
};

/// What the points of a file are like.
struct CloudLayout {
  bool with_intensities = false;  ///< points have a field for them
  /// Of intensities that las has as whole numbers: those from 0 to 1 need one.
  float intensity_scale = 1.0f;
  CloudFrame frame;
};

/// `format`: pcd (binary), ply (binary) or las (1.2, to the millimetre; intensities as whole
/// numbers of 16 bits).
/// Single precision moves points far from the origin: pcd and ply suit frames near the map's, las
/// suits all within 2,147 km of CloudFrame::origin, and names the reference system.
/// @throws std::invalid_argument for another one, std::runtime_error naming a file.
std::unique_ptr<CloudStream> makeCloudStream(const std::string& format, const std::string& path,
                                             const CloudLayout& layout);

/// Points as they lie in files: x, y and z, with intensities a fourth number.
std::string pointBytes(const Points& points, const std::vector<float>& intensities,
                       bool with_intensities);

/// @throws std::invalid_argument for a format that makeCloudStream() does not write.
void requireCloudFormat(const std::string& format);

}  // namespace revisit_slam
