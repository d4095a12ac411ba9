// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/display.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam {

using visualization_msgs::Marker;

std_msgs::ColorRGBA colour(float r, float g, float b, float a) {
  std_msgs::ColorRGBA colour;
  colour.r = r;
  colour.g = g;
  colour.b = b;
  colour.a = a;
  return colour;
}

std_msgs::ColorRGBA colourOf(std::uint32_t id) {
  constexpr double golden_ratio = 0.618033988749895, saturation = 0.65;
  const double hue = 6.0 * std::fmod(0.1 + golden_ratio * id, 1.0);
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue, 6.0);
    return static_cast<float>(1.0 - saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  };
  return colour(channel(5.0), channel(3.0), channel(1.0));
}

geometry_msgs::Point toPointMessage(const Eigen::Vector3d& p) {
  geometry_msgs::Point message;
  message.x = p.x();
  message.y = p.y();
  message.z = p.z();
  return message;
}

Marker makeMarker(const std::string& frame, const std::string& name, int id, int type, double scale,
                  const std_msgs::ColorRGBA& colour) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = name;
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = scale;
  marker.color = colour;
  return marker;
}

Marker makeText(const std::string& frame, const std::string& name, int id, double scale,
                const Eigen::Vector3d& p, const std::string& text) {
  Marker marker =
      makeMarker(frame, name, id, Marker::TEXT_VIEW_FACING, scale, colour(1.0f, 1.0f, 1.0f));
  marker.pose.position = toPointMessage(p);
  marker.text = text;
  return marker;
}

Marker deleteAll() {
  Marker marker;
  marker.action = Marker::DELETEALL;
  return marker;
}

}  // namespace revisit_slam
