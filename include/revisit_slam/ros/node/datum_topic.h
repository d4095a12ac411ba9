// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <optional>

#include "revisit_slam/types/georeference.h"

namespace revisit_slam {

/// The latched topic `datum`: where on the earth the frame enu of the map has its origin. It is
/// advertised once that is known. For one thread.
class DatumTopic {
 public:
  explicit DatumTopic(const ros::NodeHandle& node) : node_(node) {}

  /// Where it is not known there is no topic.
  void publish(const std::optional<Georeference>& georeference);

 private:
  ros::NodeHandle node_;
  ros::Publisher publisher_;
  std::optional<GeodeticPosition> told_;
};

}  // namespace revisit_slam
