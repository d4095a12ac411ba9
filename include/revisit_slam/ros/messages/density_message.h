// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/Image.h>

#include "revisit_slam/loops/recognition/place_recognition.h"

namespace revisit_slam {

/// What place recognition sees, as bgr8: x to the right, y up, every pixel twice as wide and high,
/// with a green square around each feature.
sensor_msgs::Image toDensityMessage(const PlaceView& view);

}  // namespace revisit_slam
