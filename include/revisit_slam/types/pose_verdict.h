// SPDX-License-Identifier: MIT
#pragma once

namespace revisit_slam {

/// How far the pose of a scan can be trusted.
enum class PoseVerdict {
  good,
  weak,  ///< right where the geometry holds it; it hardly does in some directions
  poor,  ///< the scan fits the map badly: the pose may be off by far more than its covariance says
  lost,  ///< the scan does not fit: the pose is a prediction, and a new voxel map begins with it
};

const char* toString(PoseVerdict verdict);

}  // namespace revisit_slam
