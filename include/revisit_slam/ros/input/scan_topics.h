// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace revisit_slam {

struct TypedTopic {
  std::string name;
  std::string type;  ///< of its messages
};

/// Whether messages of this type are scans.
bool holdsScans(const std::string& type);

/// Those that hold scans, by name. What SLAM itself publishes is none.
std::vector<TypedTopic> scanTopics(const std::vector<TypedTopic>& topics);

/// "/points, /livox/lidar", or "none".
std::string namesOf(const std::vector<TypedTopic>& topics);

/// How launch files take it: "points:=/velodyne_points".
std::string argumentFor(const TypedTopic& topic);

/// Why nothing may come on a topic that is listened to, and what to do: nobody publishes it, its
/// messages are no scans, or its publisher is silent. `all_take_livox`: also the first of them
/// takes the messages of a Livox driver.
std::string describeSilence(const std::vector<std::string>& listened,
                            const std::vector<TypedTopic>& published, bool all_take_livox = false);

}  // namespace revisit_slam
