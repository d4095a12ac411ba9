// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/localization_messages.h"

#include <cmath>

#include "revisit_slam/ros/messages/display.h"
#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {
namespace {

constexpr double kTextSize = 2.0, kAbove = 5.0;  // m

std_msgs::ColorRGBA colourOfState(LocalizationState state) {
  switch (state) {
    case LocalizationState::localized:
      return colour(0.3, 1.0, 0.3);
    case LocalizationState::lost:
      return colour(1.0, 0.3, 0.3);
    default:
      return colour(1.0, 0.9, 0.3);
  }
}

}  // namespace

geometry_msgs::PoseWithCovarianceStamped toPoseWithCovariance(const Localization& now,
                                                              const std::string& map_frame) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.stamp = toRosTime(now.stamp);
  message.header.frame_id = map_frame;
  message.pose.pose = toPoseMessage(now.T_map_base);
  const Matrix6 covariance = inFixedAxes(now.covariance, now.T_map_base);
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column)
      message.pose.covariance[static_cast<std::size_t>(6 * row + column)] = covariance(row, column);
  return message;
}

LocalizationStatus toStatus(const Localization& now, const std::string& map_frame) {
  const geometry_msgs::PoseWithCovarianceStamped pose = toPoseWithCovariance(now, map_frame);
  LocalizationStatus status;
  status.header = pose.header;
  status.state = toString(now.state);
  status.reason = now.reason;
  status.pose = pose.pose;
  status.since_fix = now.since_fix;
  status.overlap = now.overlap;
  status.coherence = now.coherence;
  status.target = now.target ? static_cast<std::int32_t>(now.target->value) : -1;
  status.target_session = now.target ? now.target->session.value : 0u;
  return status;
}

visualization_msgs::Marker toStateText(const Localization& now,
                                       const Eigen::Vector3d& p_map_unknown,
                                       const std::string& map_frame) {
  const bool is_known = now.state != LocalizationState::searching;
  const Eigen::Vector3d& p_map = is_known ? now.T_map_base.translation : p_map_unknown;
  visualization_msgs::Marker text =
      makeText(map_frame, "localization", 0, kTextSize, p_map + kAbove * Eigen::Vector3d::UnitZ(),
               std::string(toString(now.state)) + (now.reason.empty() ? "" : ": " + now.reason));
  text.color = colourOfState(now.state);
  return text;
}

std::optional<Pose> toStart(const geometry_msgs::PoseWithCovarianceStamped& drawn,
                            const std::string& map_frame, const PriorMap& map) {
  std::string frame = drawn.header.frame_id;
  if (!frame.empty() && frame.front() == '/') frame.erase(0, 1);
  if (frame != map_frame) return std::nullopt;
  const geometry_msgs::Point& p = drawn.pose.pose.position;
  const geometry_msgs::Quaternion& q = drawn.pose.pose.orientation;
  const double yaw = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
  if (!std::isfinite(p.x + p.y + yaw)) return std::nullopt;
  return map.onGround(p.x, p.y, yaw);
}

}  // namespace revisit_slam
