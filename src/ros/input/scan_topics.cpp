// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/scan_topics.h"

#include <algorithm>
#include <array>

#include "revisit_slam/ros/input/livox_custom_msg.h"

namespace revisit_slam {
namespace {

/// Clouds that the nodelets publish, by the end of their names.
constexpr std::array<const char*, 7> kOwn{"/deskewed_points", "/local_maps",     "/submaps",
                                          "/map_cloud",       "/occupied_cells", "/prior_map",
                                          "/matched_submap"};

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool isOwn(const std::string& name) {
  return std::any_of(kOwn.begin(), kOwn.end(),
                     [&](const char* own) { return endsWith(name, own); });
}

std::string join(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// What `textOf` makes of each.
template <typename TextOf>
std::string join(const std::vector<TypedTopic>& topics, const char* between, const TextOf& textOf) {
  std::vector<std::string> words(topics.size());
  std::transform(topics.begin(), topics.end(), words.begin(), textOf);
  return join(words, between);
}

std::string suggest(const std::vector<TypedTopic>& topics) {
  if (topics.empty()) return "no topic with scans is published: start the driver";
  return "start with " + join(topics, " or ", argumentFor);
}

/// Of a topic that is published and listened to.
std::string describeSilence(const TypedTopic& topic, bool takes_livox,
                            const std::vector<TypedTopic>& published) {
  const std::string type = topic.name + " is of type " + topic.type;
  if (!holdsScans(topic.type)) return type + ", not of scans: " + suggest(scanTopics(published));
  if (isLivoxCustomMsg(topic.type) && !takes_livox)
    return type + ": start with " + argumentFor(topic);
  return topic.name + " has a publisher that sends nothing: check the sensor and its driver, " +
         "with: rostopic hz " + topic.name;
}

}  // namespace

bool holdsScans(const std::string& type) {
  return type == "sensor_msgs/PointCloud2" || isLivoxCustomMsg(type);
}

std::vector<TypedTopic> scanTopics(const std::vector<TypedTopic>& topics) {
  std::vector<TypedTopic> found;
  for (const TypedTopic& topic : topics)
    if (holdsScans(topic.type) && !isOwn(topic.name)) found.push_back(topic);
  std::sort(found.begin(), found.end(),
            [](const TypedTopic& a, const TypedTopic& b) { return a.name < b.name; });
  return found;
}

std::string namesOf(const std::vector<TypedTopic>& topics) {
  if (topics.empty()) return "none";
  return join(topics, ", ", [](const TypedTopic& topic) { return topic.name; });
}

std::string argumentFor(const TypedTopic& topic) {
  return (isLivoxCustomMsg(topic.type) ? "livox_points:=" : "points:=") + topic.name;
}

std::string describeSilence(const std::vector<std::string>& listened,
                            const std::vector<TypedTopic>& published, bool all_take_livox) {
  for (const std::string& name : listened)
    for (const TypedTopic& topic : published)
      if (topic.name == name)
        return describeSilence(topic, all_take_livox || name != listened.front(), published);
  return "nobody publishes " + join(listened, " or ") + ": " + suggest(scanTopics(published));
}

}  // namespace revisit_slam
