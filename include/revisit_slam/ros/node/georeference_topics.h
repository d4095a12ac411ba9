// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <optional>
#include <string>

#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/types/map_correction.h"

namespace revisit_slam {

/// Where the map lies on the earth: the topic `datum`, latched, and the static transform from
/// frames/earth, if that is named, to the map, anew with each correction. For one thread.
class GeoreferenceTopics {
 public:
  /// Advertises nothing where no GNSS is connected.
  GeoreferenceTopics(ros::NodeHandle& node, const SlamConfig& config);

  /// Nothing for a correction that does not know.
  void publish(const MapCorrection& correction);

 private:
  void publishDatum(const MapCorrection& correction);

  const FramesConfig frames_;
  ros::Publisher datum_;
  std::optional<SessionId> told_;  // whose datum was published
  tf2_ros::StaticTransformBroadcaster broadcaster_;
};

}  // namespace revisit_slam
