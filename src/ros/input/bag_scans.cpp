// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/bag_scans.h"

#include <tf2/exceptions.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "revisit_slam/ros/input/scan_topics.h"
#include "revisit_slam/ros/messages/connected_frames.h"
#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/util/frame_name.h"

namespace revisit_slam {
namespace {

std::string join(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "none" : text;
}

/// A path that was mistyped: what there is beside it.
std::string describeMissing(const std::string& path) {
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) folder = ".";
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    return "there is no file '" + path + "', not even its folder; give the path of a bag";
  std::set<std::string> bags;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".bag") bags.insert(entry.path().string());
  return "there is no file '" + path + "'; bags in its folder: " + join(bags);
}

}  // namespace

RawMessage rawMessageOf(const rosbag::MessageInstance& instance) {
  RawMessage raw{instance.getDataType(),
                 instance.getMD5Sum(),
                 instance.getMessageDefinition(),
                 {},
                 toStamp(instance.getTime())};
  raw.bytes.resize(instance.size());
  ros::serialization::OStream out(raw.bytes.data(), static_cast<std::uint32_t>(raw.bytes.size()));
  instance.write(out);
  return raw;
}

tf2_msgs::TFMessage transformsOf(const RawMessage& raw) {
  constexpr std::size_t least = 80;  // bytes of a transform: numbers, and lengths of three names
  if (MessageBytes(raw.bytes).number<std::uint32_t>() > raw.bytes.size() / least)
    throw std::runtime_error("more transforms announced than there are");
  ros::serialization::IStream in(const_cast<std::uint8_t*>(raw.bytes.data()),
                                 static_cast<std::uint32_t>(raw.bytes.size()));
  tf2_msgs::TFMessage message;
  ros::serialization::deserialize(in, message);
  return message;
}

ScanReading readScan(const rosbag::MessageInstance& instance, ScanReader& reader) {
  try {
    return reader.read(rawMessageOf(instance));
  } catch (const std::exception& error) {
    ScanReading reading;
    reading.rejection = ScanRejection::bad_layout;
    reading.detail = std::string("the bag is damaged: ") + error.what();
    return reading;
  }
}

BagScans::BagScans(const std::vector<std::string>& paths, const std::vector<std::string>& topics) {
  for (const std::string& path : paths) open(path);
  for (const std::string& topic : topics) topics_.push_back(chooseTopic(topic));
  scans_ = std::make_unique<rosbag::View>();
  for (const auto& bag : bags_) scans_->addQuery(*bag, rosbag::TopicQuery(topics_));
  readTransforms();
}

std::string BagScans::topic() const {
  std::string all;
  for (const std::string& topic : topics_) all += (all.empty() ? "" : " ") + topic;
  return all;
}

std::size_t BagScans::sensorOf(const std::string& topic) const {
  return static_cast<std::size_t>(std::find(topics_.begin(), topics_.end(), topic) -
                                  topics_.begin());
}

void BagScans::open(const std::string& path) {
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown)) throw BagError(describeMissing(path));
  bags_.push_back(std::make_unique<rosbag::Bag>());
  try {
    bags_.back()->open(path, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw BagError(
        "the bag '" + path +
        "' has no index, its recording was cut off; make one with: " + "rosbag reindex " + path);
  } catch (const rosbag::BagException& error) {
    throw BagError("cannot read the bag '" + path + "': " + error.what() +
                   "; if it was cut off, try: rosbag reindex " + path);
  }
}

std::string BagScans::chooseTopic(const std::string& wanted) {
  std::set<std::string> topics, topics_with_scans;
  std::map<std::string, std::string> types;
  for (const auto& bag : bags_) {
    rosbag::View view(*bag);
    for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
      types[connection->topic] = connection->datatype;
      topics.insert(connection->topic);
      if (holdsScans(connection->datatype)) topics_with_scans.insert(connection->topic);
    }
  }
  const std::string found =
      topics_with_scans.empty()
          ? "; its topics: " + join(topics)
          : "; choose with --points (points:= in launch files) one of: " + join(topics_with_scans);
  if (wanted.empty()) {
    if (topics_with_scans.size() == 1) return *topics_with_scans.begin();
    throw BagError(
        (topics_with_scans.empty() ? "the bag has no topic with scans"
                                   : "the bag has several topics with scans") +
        found +
        (topics_with_scans.empty() ? "" : "; or merge sensors of one robot by input/topics"));
  }
  if (types.count(wanted) == 0) throw BagError("the bag has no topic '" + wanted + "'" + found);
  if (topics_with_scans.count(wanted) == 0)
    throw BagError("topic '" + wanted + "' is of type " + types[wanted] + ", not of scans" + found);
  return wanted;
}

std::unique_ptr<rosbag::View> BagScans::messagesWith(const PriorsConfig& priors,
                                                     const GnssConfig& gnss) const {
  std::vector<std::string> topics = topics_;
  const auto add = [&](const std::string& topic, const char* type, const char* parameter) {
    requireTopic(topic, type, parameter);
    topics.push_back(topic);
  };
  if (!priors.odometry_topic.empty())
    add(priors.odometry_topic, "nav_msgs/Odometry", "priors/odometry_topic");
  if (!priors.odometry_frame.empty()) add("/tf", "tf2_msgs/TFMessage", "priors/odometry_frame");
  if (!priors.imu_topic.empty()) add(priors.imu_topic, "sensor_msgs/Imu", "priors/imu_topic");
  if (gnss.isConnected()) add(gnss.topic, "sensor_msgs/NavSatFix", "gnss/topic");
  auto messages = std::make_unique<rosbag::View>();
  for (const auto& bag : bags_) messages->addQuery(*bag, rosbag::TopicQuery(topics));
  return messages;
}

void BagScans::requireTopic(const std::string& topic, const std::string& type,
                            const std::string& parameter) const {
  std::set<std::string> of_type;
  for (const auto& bag : bags_) {
    rosbag::View view(*bag);
    for (const rosbag::ConnectionInfo* connection : view.getConnections())
      if (connection->datatype == type) of_type.insert(connection->topic);
  }
  if (of_type.count(topic) == 0)
    throw BagError("the bag has no topic '" + topic + "' of type " + type + ", which " + parameter +
                   " needs; topics of this type: " + join(of_type));
}

void BagScans::readTransforms() {
  std::set<std::string>
      children;  // the first transform of a frame stays: static ones before others
  const auto keep = [&](const geometry_msgs::TransformStamped& transform) {
    if (!children.insert(transform.child_frame_id).second) return;
    has_transforms_ |= transforms_.setTransform(transform, "bag", true);
  };
  for (const char* topic : {"/tf_static", "/tf"}) {
    for (const auto& bag : bags_) {
      rosbag::View view(*bag, rosbag::TopicQuery(topic));
      for (const rosbag::MessageInstance& instance : view) {
        if (!instance.isType<tf2_msgs::TFMessage>()) continue;
        try {
          for (const auto& transform : transformsOf(rawMessageOf(instance)).transforms)
            keep(transform);
        } catch (const std::exception&) {
          ++damaged_transforms_;
        }
      }
    }
  }
}

std::string BagScans::sensorFrame(std::size_t sensor) {
  for (const rosbag::MessageInstance& instance : *scans_) {
    if (instance.getTopic() != topics_[sensor]) continue;
    try {
      const RawMessage raw = rawMessageOf(instance);
      PointMessage message;
      MessageBytes(raw.bytes).header(message);
      return message.frame_id;
    } catch (const std::exception&) {
      // The next one.
    }
  }
  return "";
}

std::vector<std::string> BagScans::framesAround(const std::string& frame) const {
  return framesConnectedWith(frame, transforms_);
}

std::optional<Pose> BagScans::findExtrinsics(const std::string& base_frame,
                                             const std::string& sensor_frame) const {
  try {
    return toPose(transforms_
                      .lookupTransform(withoutLeadingSlash(base_frame),
                                       withoutLeadingSlash(sensor_frame), ros::Time(0))
                      .transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

}  // namespace revisit_slam
