// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/cloud_subscription.h"

#include <ros/subscription_callback_helper.h>

#include <boost/make_shared.hpp>
#include <exception>
#include <utility>

#include "revisit_slam/ros/input/point_message.h"

namespace revisit_slam {
namespace {

using CloudEvent = ros::MessageEvent<const sensor_msgs::PointCloud2>;
using CloudHelper = ros::SubscriptionCallbackHelperT<const CloudEvent&>;

class CheckedClouds : public CloudHelper {
 public:
  CheckedClouds(const Callback& on_cloud, std::function<void(const std::string&)> on_damaged)
      : CloudHelper(on_cloud), on_damaged_(std::move(on_damaged)) {}

  ros::VoidConstPtr deserialize(
      const ros::SubscriptionCallbackHelperDeserializeParams& params) override {
    try {
      parsePointCloud2(MessageBytes(params.buffer, params.length));
      return CloudHelper::deserialize(params);
    } catch (const std::exception& error) {
      on_damaged_(error.what());
      return {};
    }
  }

 private:
  const std::function<void(const std::string&)> on_damaged_;
};

}  // namespace

ros::Subscriber subscribeToClouds(ros::NodeHandle& node, const std::string& topic,
                                  const std::function<void(const CloudEvent&)>& on_cloud,
                                  const std::function<void(const std::string&)>& on_damaged) {
  ros::SubscribeOptions options;
  options.topic = topic;
  options.queue_size = 0;
  options.md5sum = ros::message_traits::md5sum<sensor_msgs::PointCloud2>();
  options.datatype = ros::message_traits::datatype<sensor_msgs::PointCloud2>();
  options.helper = boost::make_shared<CheckedClouds>(on_cloud, on_damaged);
  return node.subscribe(options);
}

}  // namespace revisit_slam
