// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <revisit_slam/DisableLoop.h>
#include <revisit_slam/LoadMap.h>
#include <revisit_slam/SaveMap.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "revisit_slam/ros/node/stage_topics.h"
#include "support/odometry_listener.h"

namespace revisit_slam {

/// All nodelets of one mode in this process, in a namespace of their own, and what passes between
/// them.
class LiveSlam {
 public:
  using CloudPtr = sensor_msgs::PointCloud2::ConstPtr;

  explicit LiveSlam(const std::string& name, const std::string& folder = "")
      : space_("/" + name + "/"), node_(space_), listener_(space_) {
    for (const char* nodelet : kNodelets) {
      set(nodelet, "frames/base", std::string());  // the sensor's own
      set(nodelet, "live/diagnostics_period", 0.2);
      set(nodelet, "live/queue_size", 10000);
      set(nodelet, "live/folder", folder);
      set(nodelet, "information/max_waiting", 10000);
      set(nodelet, "mapping/max_waiting", 10000);
    }
    points_ = node_.advertise<sensor_msgs::PointCloud2>("points", 1000);
    subscribers_.push_back(node_.subscribe<InformedScan>(
        "informed_scan", 0, [this](const boost::shared_ptr<const InformedScan>&) { ++informed_; }));
    subscribe("submap", maps);
    subscribe("loop_constraints", loops);
    subscribe("map_correction", corrections);
  }
  ~LiveSlam() {
    loader_.clear();
    for (ros::Subscriber& subscriber : subscribers_) subscriber.shutdown();
    ros::param::del(space_);
  }

  template <typename T>
  void set(const std::string& nodelet, const std::string& name, const T& value) {
    ros::param::set(space_ + nodelet + "/" + name, value);
  }

  /// The same on every nodelet, as slam.launch has it.
  template <typename T>
  void setAll(const std::string& name, const T& value) {
    for (const char* nodelet : kNodelets) set(nodelet, name, value);
  }

  /// Those that map, in an order in which scans would be lost if nobody waited.
  void load() {
    load({{"odometry", "Odometry"},
          {"information", "Information"},
          {"map_manager", "MapManager"},
          {"back_end", "BackEnd"}});
  }
  /// Those that localize in a map.
  void loadLocalization(const std::string& map) {
    setAll("localization/map", map);
    setAll("mapping/enabled", false);
    load({{"localization", "Localization"},
          {"information", "Information"},
          {"odometry", "Odometry"}});
  }
  void load(const std::vector<std::pair<std::string, std::string>>& nodelets) {
    for (const auto& [name, type] : nodelets)
      ASSERT_TRUE(loader_.load(space_ + name, std::string("revisit_slam/") + type, {}, {}));
    ASSERT_TRUE(
        becomesTrue([this] { return listener_.isConnected() && points_.getNumSubscribers() > 0; }));
  }

  void unload() { loader_.clear(); }

  /// As fast as the odometry takes them, and until the last one is on its way to the maps.
  void play(const std::vector<CloudPtr>& clouds) {
    constexpr std::size_t ahead = 20;
    const std::size_t before = informed_;
    for (std::size_t i = 0; i < clouds.size(); ++i) {
      ASSERT_TRUE(i < ahead || listener_.hasPoses(before + i - ahead)) << i;
      points_.publish(clouds[i]);
    }
    ASSERT_TRUE(becomesTrue([&] { return informed_ == before + clouds.size(); }));
  }

  template <typename Service>
  Service call(const std::string& name, Service service = {}) {
    EXPECT_TRUE(ros::service::call(space_ + name, service)) << name;
    return service;
  }
  std_srvs::Trigger::Response trigger(const std::string& name) {
    return call<std_srvs::Trigger>(name).response;
  }

  LoadMap::Response loadMap(const std::string& nodelet, const std::string& map) {
    LoadMap service;
    service.request.map = map;
    return call(nodelet + "/load", service).response;
  }

  SaveMap::Response save(const std::string& folder) {
    SaveMap service;
    service.request.folder = folder;
    return call("back_end/save", service).response;
  }

  /// Messages so far.
  template <typename T>
  std::vector<boost::shared_ptr<const T>> copyOf(
      const std::vector<boost::shared_ptr<const T>>& all) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return all;
  }

  const std::string& space() const { return space_; }
  const OdometryListener& listener() const { return listener_; }
  ros::NodeHandle& node() { return node_; }

  std::vector<boost::shared_ptr<const MapUpdate>> maps;
  std::vector<boost::shared_ptr<const LoopClosures>> loops;
  std::vector<boost::shared_ptr<const MapCorrection>> corrections;

 private:
  static constexpr const char* kNodelets[] = {"odometry", "information", "map_manager", "back_end",
                                              "localization"};

  template <typename T>
  void subscribe(const std::string& topic, std::vector<boost::shared_ptr<const T>>& kept) {
    subscribers_.push_back(
        node_.subscribe<T>(topic, 0, [this, &kept](const boost::shared_ptr<const T>& message) {
          const std::lock_guard<std::mutex> lock(mutex_);
          kept.push_back(message);
        }));
  }

  std::string space_;
  ros::NodeHandle node_;
  OdometryListener listener_;
  ros::Publisher points_;
  std::atomic<std::size_t> informed_{0};
  std::mutex mutex_;  // guards the messages
  std::vector<ros::Subscriber> subscribers_;
  nodelet::Loader loader_{false};
};

template <typename Message>
std::vector<typename Message::ConstPtr> messagesOf(const std::string& bag_path,
                                                   const std::string& topic) {
  rosbag::Bag bag(bag_path, rosbag::bagmode::Read);
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  std::vector<typename Message::ConstPtr> messages;
  for (const rosbag::MessageInstance& message : view)
    messages.push_back(message.instantiate<Message>());
  return messages;
}

/// The scans of a bag.
inline std::vector<LiveSlam::CloudPtr> scansOf(const std::string& bag_path) {
  return messagesOf<sensor_msgs::PointCloud2>(bag_path, "/points");
}

}  // namespace revisit_slam
