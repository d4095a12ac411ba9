// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/child_process.h"
#include "support/odometry_listener.h"
#include "support/point_cloud_builder.h"
#include "support/raw_messages.h"
#include "support/synthetic_drive.h"

namespace revisit_slam {
namespace {

using Field = sensor_msgs::PointField;
using Points = std::vector<TestPoint>;

/// A launch file in launch/drivers whose driver runs elsewhere: here.
class DriverLaunch {
 public:
  DriverLaunch(const std::string& driver, const std::string& sensor_frame)
      : sensor_frame_(sensor_frame),
        launch_({"roslaunch", "revisit_slam", driver + ".launch", "driver:=false",
                 "sensor_frame:=" + sensor_frame, "sensor_pose:=0 0 0 0 0 0"}) {}

  /// `send` publishes the points of a scan, with times in seconds behind the first point.
  template <typename Send>
  void expectDrive(const ros::Publisher& publisher, const Send& send) {
    const OdometryListener listener;
    ASSERT_TRUE(becomesTrue(
        [&] { return listener.isConnected() && publisher.getNumSubscribers() > 0; }, 60.0))
        << launch_.output();
    const Drive drive = driveInRoom(12);
    for (const Scan& scan : drive.scans) {
      const double seconds = -*std::min_element(scan.times.begin(), scan.times.end());
      Points points;
      for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const Eigen::Vector3d p = scan.points[i].cast<double>();
        points.push_back({p.x(), p.y(), p.z(), seconds + scan.times[i]});
      }
      send(scan.stamp.nanoseconds - static_cast<std::int64_t>(1e9 * seconds), seconds, points);
    }
    ASSERT_TRUE(listener.hasPoses(12)) << launch_.output() << listener.message();
    EXPECT_EQ(listener.message().find("deskewing off"), std::string::npos) << listener.message();
    const Pose& T_base_sensor = drive.scans[0].T_base_sensor;  // of the drive; here they are one
    const Pose T_expected = T_base_sensor.inverse() * drive.T_first_base.back() * T_base_sensor;
    EXPECT_LT(distanceBetween(listener.trajectory().back().T_world_base, T_expected), 0.1);
    launch_.interrupt();
    EXPECT_NE(launch_.wait(60.0), ChildProcess::still_running);
  }

  void expectClouds(const std::string& topic, PointCloudBuilder builder, double header_fraction,
                    double unit, bool absolute) {
    ros::Publisher publisher = node_.advertise<sensor_msgs::PointCloud2>(topic, 100);
    expectDrive(publisher, [&](std::int64_t first, double seconds, Points points) {
      const std::int64_t header =
          first + static_cast<std::int64_t>(1e9 * header_fraction * seconds);
      for (TestPoint& p : points)
        p.time = absolute ? 1e-9 * static_cast<double>(first) + p.time
                          : (p.time - header_fraction * seconds) / unit;
      sensor_msgs::PointCloud2 cloud = builder.build(points);
      cloud.header.stamp.fromNSec(static_cast<std::uint64_t>(header));
      cloud.header.frame_id = sensor_frame_;
      publisher.publish(cloud);
    });
  }

  ros::NodeHandle& node() { return node_; }

 private:
  const std::string sensor_frame_;
  ros::NodeHandle node_;
  ChildProcess launch_;
};

TEST(DriverLaunch, velodyneWithTimesBeforeTheHeader) {
  const auto cloud = PointCloudBuilder()
                         .xyz()
                         .field("intensity", Field::FLOAT32, 12)
                         .field("ring", Field::UINT16, 16)
                         .field("time", Field::FLOAT32, 18);
  DriverLaunch("velodyne", "velodyne").expectClouds("/velodyne_points", cloud, 1.0, 1.0, false);
}

TEST(DriverLaunch, ousterWithNanosecondsBehindTheHeader) {
  const auto cloud = PointCloudBuilder()
                         .xyz()
                         .field("intensity", Field::FLOAT32, 16)
                         .field("t", Field::UINT32, 20)
                         .field("reflectivity", Field::UINT16, 24)
                         .field("ring", Field::UINT16, 26)
                         .field("ambient", Field::UINT16, 28)
                         .field("range", Field::UINT32, 32);
  DriverLaunch("ouster", "os_sensor").expectClouds("/ouster/points", cloud, 0.0, 1e-9, false);
}

TEST(DriverLaunch, hesaiWithAbsoluteTimes) {
  const auto cloud = PointCloudBuilder()
                         .xyz()
                         .field("intensity", Field::FLOAT32, 16)
                         .field("timestamp", Field::FLOAT64, 24)
                         .field("ring", Field::UINT16, 32);
  DriverLaunch("hesai", "hesai_lidar").expectClouds("/lidar_points", cloud, 0.0, 1.0, true);
}

TEST(DriverLaunch, rslidarWithAbsoluteTimesAtAnUnalignedOffset) {
  const auto cloud = PointCloudBuilder()
                         .xyz()
                         .field("intensity", Field::FLOAT32, 12)
                         .field("ring", Field::UINT16, 16)
                         .field("timestamp", Field::FLOAT64, 18);
  DriverLaunch("rslidar", "rslidar").expectClouds("/rslidar_points", cloud, 1.0, 1.0, true);
}

TEST(DriverLaunch, livoxCustomMsg) {
  DriverLaunch launch("livox", "livox_frame");
  const std::string type = "livox_ros_driver2/CustomMsg";
  const auto empty = shapeShifter(livoxBytes(0, 0, {}), type);
  ros::Publisher publisher = empty.advertise(launch.node(), "/livox/lidar", 100);
  launch.expectDrive(publisher, [&](std::int64_t first, double, Points points) {
    for (TestPoint& p : points) p.time *= 1e9;
    publisher.publish(shapeShifter(livoxBytes(first, first, points), type));
  });
}

}  // namespace
}  // namespace revisit_slam
