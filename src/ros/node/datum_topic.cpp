// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/datum_topic.h"

#include <sensor_msgs/NavSatFix.h>

namespace revisit_slam {
void DatumTopic::publish(const std::optional<Georeference>& georeference) {
  if (!georeference) {  // what was latched is of another map
    publisher_.shutdown();
    publisher_ = {};
    told_.reset();
    return;
  }
  if (told_ && areEqual(*told_, georeference->datum)) return;
  told_ = georeference->datum;
  const bool latch = true;
  if (!publisher_) publisher_ = node_.advertise<sensor_msgs::NavSatFix>("datum", 1, latch);
  sensor_msgs::NavSatFix message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = "enu";
  message.latitude = told_->latitude;
  message.longitude = told_->longitude;
  message.altitude = told_->altitude;
  publisher_.publish(message);
}

}  // namespace revisit_slam
