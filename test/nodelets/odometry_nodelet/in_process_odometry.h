// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <sensor_msgs/PointCloud2.h>

#include <boost/make_shared.hpp>

#include "support/odometry_listener.h"
#include "support/scan_clouds.h"

namespace revisit_slam {

/// An odometry nodelet in this process, in a namespace of its own.
class InProcessOdometry : public ::testing::Test {
 protected:
  using CloudPtr = boost::shared_ptr<const sensor_msgs::PointCloud2>;

  InProcessOdometry() : listener_(space_) {
    setParameter("live/diagnostics_period", 0.1);
    setParameter("odometry/max_range", roomConfig().max_range);
    setParameter("odometry/map/voxel_size", roomConfig().map.voxel_size);
    setParameter("frames/base", std::string());  // the sensor's own
  }
  ~InProcessOdometry() override {
    loader_.clear();
    ros::param::del(space_ + "odometry");
  }

  template <typename T>
  void setParameter(const std::string& name, const T& value) {
    ros::param::set(space_ + "odometry/" + name, value);
  }

  void load() {
    ASSERT_TRUE(loader_.load(space_ + "odometry", "revisit_slam/Odometry", {}, {}));
    ASSERT_TRUE(becomesTrue([this] { return listener_.isConnected(); }));
    ASSERT_TRUE(becomesTrue([this] { return points_.getNumSubscribers() > 0; }));
  }

  CloudPtr publish(const sensor_msgs::PointCloud2& cloud) {
    const CloudPtr message = boost::make_shared<const sensor_msgs::PointCloud2>(cloud);
    points_.publish(message);
    return message;
  }

  const std::string name_ = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::string space_ = "/" + name_ + "/";
  ros::NodeHandle node_{space_};
  OdometryListener listener_;
  ros::Publisher points_ = node_.advertise<sensor_msgs::PointCloud2>("points", 1000);
  nodelet::Loader loader_{false};
};

}  // namespace revisit_slam
