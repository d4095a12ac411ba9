// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/connected_frames.h"

#include <algorithm>

namespace revisit_slam {

std::vector<std::string> framesConnectedWith(const std::string& frame,
                                             const tf2::BufferCore& transforms) {
  std::vector<std::string> known, connected;
  if (frame.empty() || !transforms._frameExists(frame)) return connected;
  transforms._getFrameStrings(known);
  std::copy_if(known.begin(), known.end(), std::back_inserter(connected),
               [&](const std::string& other) {
                 return other != frame && transforms._frameExists(other) &&
                        transforms.canTransform(other, frame, ros::Time(0));
               });
  std::sort(connected.begin(), connected.end());
  return connected;
}

std::string listOf(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace revisit_slam
