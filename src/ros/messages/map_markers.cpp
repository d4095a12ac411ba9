// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/map_markers.h"

#include <Eigen/Geometry>

#include "revisit_slam/ros/messages/display.h"

namespace revisit_slam {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Around the points seen from above, at the height of the keypose.
std::vector<geometry_msgs::Point> outlineOf(const Points& points, const Pose& T) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3f& point : points)
    box.extend(Eigen::Vector2d(point.head<2>().cast<double>()));
  std::vector<geometry_msgs::Point> outline;
  using Box = Eigen::AlignedBox2d;
  for (const auto corner :
       {Box::BottomLeft, Box::BottomRight, Box::TopRight, Box::TopLeft, Box::BottomLeft}) {
    const Eigen::Vector2d p = box.corner(corner);
    outline.push_back(toPointMessage(T * Eigen::Vector3d(p.x(), p.y(), 0.0)));
  }
  return outline;
}

}  // namespace

MarkerArray toOutlines(const std::vector<LocalMapPtr>& maps, const std::vector<Pose>& T_map_local,
                       const std::string& frame) {
  MarkerArray array;
  array.markers.push_back(deleteAll());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const LocalMap& map = *maps[i];
    if (map.points.empty()) continue;
    const int id = static_cast<int>(map.id.value);
    Marker box = makeMarker(frame, "outlines", id, Marker::LINE_STRIP, 0.3, colourOf(map.id.value));
    box.points = outlineOf(map.points, T_map_local.at(i));
    array.markers.push_back(box);
    const Eigen::Vector3d above(0.0, 0.0, 8.0);
    array.markers.push_back(
        makeText(frame, "numbers", id, 5.0, T_map_local[i] * above, std::to_string(id)));
  }
  return array;
}

MarkerArray toKeyposes(const std::vector<SubmapPtr>& submaps, const std::vector<Pose>& T_map_submap,
                       const std::string& frame) {
  MarkerArray array;
  array.markers.push_back(deleteAll());
  Marker spheres = makeMarker(frame, "keyposes", 0, Marker::SPHERE_LIST, 1.5, colour(1, 1, 1));
  for (std::size_t i = 0; i < submaps.size(); ++i) {
    spheres.points.push_back(toPointMessage(T_map_submap.at(i).translation));
    spheres.colors.push_back(colourOf(submaps[i]->local_map.value));
  }
  if (!submaps.empty()) array.markers.push_back(spheres);
  return array;
}

}  // namespace revisit_slam
