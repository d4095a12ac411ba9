// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/mapping/submap_library.h"

namespace revisit_slam {

/// A saved map to be drawn again and again, in grey: a share of its points, which stays in memory.
class PriorCloud {
 public:
  PriorCloud() = default;
  /// Reads the submaps once, and leaves out those that cannot be read. `submaps`: without points.
  PriorCloud(const std::vector<SubmapPtr>& submaps, SubmapLibrary& library, int max_points);

  /// `place`: of a submap (without points) in `frame`; those without a place are not drawn.
  sensor_msgs::PointCloud2 draw(
      const std::string& frame,
      const std::function<std::optional<Pose>(const Submap&)>& place) const;

 private:
  struct Part {
    SubmapPtr submap;  // without points
    Points points;
  };

  std::vector<Part> parts_;
  int max_points_ = 0;
};

}  // namespace revisit_slam
