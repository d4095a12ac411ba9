// SPDX-License-Identifier: MIT
#pragma once

#include <geometry_msgs/Point.h>
#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/Marker.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>

namespace revisit_slam {

/// A bright colour; those of ids near each other differ most.
std_msgs::ColorRGBA colourOf(std::uint32_t id);

std_msgs::ColorRGBA colour(float r, float g, float b, float a = 1.0f);

geometry_msgs::Point toPointMessage(const Eigen::Vector3d& p);

/// A marker without points at the origin of `frame`, as wide as `scale` metres. Not dated: rviz
/// shows it with the newest transform.
visualization_msgs::Marker makeMarker(const std::string& frame, const std::string& name, int id,
                                      int type, double scale, const std_msgs::ColorRGBA& colour);

/// Letters of a height of `scale` metres that face the viewer.
visualization_msgs::Marker makeText(const std::string& frame, const std::string& name, int id,
                                    double scale, const Eigen::Vector3d& p,
                                    const std::string& text);

/// Deletes all markers of the topic.
visualization_msgs::Marker deleteAll();

}  // namespace revisit_slam
