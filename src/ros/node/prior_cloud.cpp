// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/prior_cloud.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "revisit_slam/ros/messages/coloured_cloud.h"
#include "revisit_slam/ros/messages/display.h"

namespace revisit_slam {
namespace {

Points eachOf(const Points& all, std::size_t step) {
  Points some;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

}  // namespace

PriorCloud::PriorCloud(const std::vector<SubmapPtr>& submaps, SubmapLibrary& library,
                       int max_points)
    : max_points_(max_points) {
  std::size_t total = 0;
  for (const SubmapPtr& submap : submaps) total += library.points(submap->id);
  const auto most = static_cast<std::size_t>(max_points);
  const std::size_t step = std::max<std::size_t>(1, (total + most - 1) / most);
  for (const SubmapPtr& submap : submaps) {
    try {
      parts_.push_back({submap, eachOf(library.whole(submap->id)->points, step)});
    } catch (const std::runtime_error&) {  // said where it is needed for more than the picture
    }
  }
}

sensor_msgs::PointCloud2 PriorCloud::draw(
    const std::string& frame,
    const std::function<std::optional<Pose>(const Submap&)>& place) const {
  std::vector<CloudPart> parts;
  for (const Part& part : parts_)
    if (const std::optional<Pose> T = place(*part.submap))
      parts.push_back({&part.points, *T, colour(0.5, 0.5, 0.5)});
  return toColouredCloud(parts, frame, max_points_);
}

}  // namespace revisit_slam
