// SPDX-License-Identifier: MIT
// What may be changed while the odometry runs: parameters, reset.
#include <dynamic_reconfigure/Reconfigure.h>
#include <revisit_slam/LiveOdometryConfig.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <limits>
#include <mutex>
#include <thread>

#include "in_process_odometry.h"
#include "revisit_slam/ros/node/stage_topics.h"
#include "support/contains.h"
#include "support/ros_log.h"

namespace revisit_slam {
namespace {

class LiveControl : public InProcessOdometry {
 protected:
  /// Returns the value in force afterwards.
  double setMaxRange(double value) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config.doubles.resize(1);
    call.request.config.doubles[0].name = "max_range";
    call.request.config.doubles[0].value = value;
    EXPECT_TRUE(ros::service::call(space_ + "odometry/odometry/set_parameters", call));
    LiveOdometryConfig config = LiveOdometryConfig::__getDefault__();
    config.__fromMessage__(call.response.config);
    return config.max_range;
  }

  /// Registers the drive's next scan; returns how many of its points were too far.
  int pointsTooFar() {
    const int before = listener_.diagnosed("points dropped, too far");
    publish(clouds_[next_]);
    EXPECT_TRUE(listener_.diagnoses("scans received", static_cast<int>(++next_)));
    return listener_.diagnosed("points dropped, too far") - before;
  }

  const std::vector<sensor_msgs::PointCloud2> clouds_ = toClouds(driveInRoom(6));
  std::size_t next_ = 0;
};

TEST_F(LiveControl, oldNameOfAParameterIsAcceptedWithAWarning) {
  setParameter("loops/agreement/rotation", 2.0);
  const RosLog log;
  load();
  EXPECT_TRUE(contains(log.text(), "is now called 'loops/consistency/rotation'"));
}

/// The server would take what it does not find on the parameter server from its own defaults.
TEST_F(LiveControl, beginsWithTheValuesOfThePresetAndOfTexts) {
  setParameter("preset", std::string("paper"));
  setParameter("odometry/max_range", std::string("3e1"));
  load();
  dynamic_reconfigure::Reconfigure call;
  ASSERT_TRUE(ros::service::call(space_ + "odometry/odometry/set_parameters", call));
  LiveOdometryConfig config = LiveOdometryConfig::__getDefault__();
  config.__fromMessage__(call.response.config);
  EXPECT_EQ(config.min_range, 0.0);
  EXPECT_EQ(config.max_prediction_time, 60.0);
  EXPECT_EQ(config.max_range, 30.0);
}

TEST_F(LiveControl, maximumRangeAppliesFromTheNextScan) {
  load();
  EXPECT_EQ(pointsTooFar(), 0);
  EXPECT_EQ(setMaxRange(5.0), 5.0);
  EXPECT_GT(pointsTooFar(), 1000);
  EXPECT_EQ(setMaxRange(60.0), 60.0);
  EXPECT_EQ(pointsTooFar(), 0);
  EXPECT_EQ(listener_.diagnosed("scans processed"), 3);
}

TEST_F(LiveControl, valuesThatAreNotAllowedDoNoHarm) {
  load();
  EXPECT_EQ(pointsTooFar(), 0);
  EXPECT_EQ(setMaxRange(1e9), 1000.0);
  EXPECT_EQ(pointsTooFar(), 0);
  EXPECT_EQ(setMaxRange(-1.0), 1.0);
  EXPECT_GT(pointsTooFar(), 1000);
  EXPECT_EQ(setMaxRange(60.0), 60.0);
  EXPECT_EQ(setMaxRange(std::numeric_limits<double>::quiet_NaN()), 60.0);
  EXPECT_EQ(pointsTooFar(), 0);
}

TEST_F(LiveControl, resetStartsAnewFromTheIdentity) {
  load();
  for (const auto& cloud : clouds_) publish(cloud);
  ASSERT_TRUE(listener_.hasPoses(6));
  std_srvs::Trigger call;
  ASSERT_TRUE(ros::service::call(space_ + "odometry/reset", call));
  EXPECT_TRUE(call.response.success);

  for (const auto& cloud : clouds_) publish(cloud);  // older than those before, and welcome
  ASSERT_TRUE(listener_.hasPoses(12));
  ASSERT_TRUE(listener_.diagnoses("scans received", 6));
  const Trajectory poses = listener_.trajectory();
  EXPECT_EQ(poses[6].T_world_base.translation.norm(), 0.0);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(distanceBetween(poses[i].T_world_base, poses[i + 6].T_world_base), 0.0);
}

/// A reset may come at any moment of a scan's life; none is placed as if the sensor were the base.
TEST_F(LiveControl, atAnyMomentOfAResetScansArePlacedByTheirTransform) {
  setParameter("frames/base", std::string("robot"));
  load();
  std::mutex mutex;
  std::size_t scans = 0, misplaced = 0;
  const Eigen::Vector3d mounted(0.4, -0.2, 1.1);
  const auto subscriber = node_.subscribe<OdometryOutput>(
      "registered_scan", 0, [&](const boost::shared_ptr<const OdometryOutput>& output) {
        const std::lock_guard<std::mutex> lock(mutex);
        ++scans;
        misplaced += (output->scan->sensor_base - mounted).norm() > 1e-3;
      });
  ASSERT_TRUE(becomesTrue([&] { return subscriber.getNumPublishers() > 0; }));
  tf2_ros::StaticTransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped mounting;
  mounting.header.frame_id = "robot";
  mounting.child_frame_id = "lidar";
  mounting.transform = toTransformMessage({Eigen::Quaterniond::Identity(), mounted});
  broadcaster.sendTransform(mounting);
  constexpr int resets = 150;
  sensor_msgs::PointCloud2 cloud = clouds_.front();
  std::thread sensor([&] {
    for (int i = 0; i < 2 * resets; ++i) {
      cloud.header.stamp += ros::Duration(0.1);
      publish(cloud);
      ros::WallDuration(0.002).sleep();
    }
  });
  std_srvs::Trigger call;
  int done = 0;  // ROS loses some of so many calls
  for (int i = 0; i < resets; ++i) done += ros::service::call(space_ + "odometry/reset", call);
  sensor.join();
  EXPECT_GT(done, resets / 2);
  ASSERT_TRUE(listener_.diagnoses("scans waiting", 0));
  const std::lock_guard<std::mutex> lock(mutex);
  EXPECT_GT(scans, 0u);
  EXPECT_EQ(misplaced, 0u);
}

}  // namespace
}  // namespace revisit_slam
