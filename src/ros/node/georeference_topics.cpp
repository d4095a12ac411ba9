// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/georeference_topics.h"

#include <sensor_msgs/NavSatFix.h>

#include "revisit_slam/geometry/local_enu.h"
#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {

GeoreferenceTopics::GeoreferenceTopics(ros::NodeHandle& node, const SlamConfig& config)
    : frames_(config.frames) {
  const bool latch = true;
  if (config.gnss.isConnected()) datum_ = node.advertise<sensor_msgs::NavSatFix>("datum", 1, latch);
}

void GeoreferenceTopics::publish(const MapCorrection& correction) {
  if (!datum_ || !correction.georeference) return;
  if (told_ != correction.session) publishDatum(correction);
  told_ = correction.session;
  if (frames_.earth.empty()) return;
  const Georeference& georeference = *correction.georeference;
  geometry_msgs::TransformStamped message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = frames_.earth;
  message.child_frame_id = frames_.map;
  message.transform =
      toTransformMessage(LocalEnu(georeference.datum).T_ecef_enu() * georeference.T_enu_map);
  broadcaster_.sendTransform(message);
}

void GeoreferenceTopics::publishDatum(const MapCorrection& correction) {
  sensor_msgs::NavSatFix message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = "enu";
  message.latitude = correction.georeference->datum.latitude;
  message.longitude = correction.georeference->datum.longitude;
  message.altitude = correction.georeference->datum.altitude;
  datum_.publish(message);
}

}  // namespace revisit_slam
