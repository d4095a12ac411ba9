// SPDX-License-Identifier: MIT
#include <sensor_msgs/Imu.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <algorithm>

#include "drive_with_loops.h"

namespace revisit_slam {
namespace {

TEST(Gravity, aLiveDriveIsAsLevelAsTheOfflineProgramHasIt) {
  DriveWithLoops& drive = DriveWithLoops::get();
  const OfflineProgram offline(
      drive.bag(), {"--set", "frames/base=base_link", "priors/imu_topic=/imu", "--quiet"});
  ASSERT_EQ(offline.status, 0) << offline.output;
  ASSERT_GT(offline.summary()["priors"]["gravity"]["scans"]["used"], 10);

  LiveSlam slam("gravity");
  slam.setAll("frames/base", std::string("base_link"));
  slam.setAll("priors/imu_topic", std::string("imu"));
  ros::Publisher imu = slam.node().advertise<sensor_msgs::Imu>("imu", 0);
  tf2_ros::StaticTransformBroadcaster mountings;
  for (const auto& message : messagesOf<tf2_msgs::TFMessage>(drive.bag(), "/tf_static"))
    mountings.sendTransform(message->transforms);
  slam.load();
  ASSERT_TRUE(becomesTrue([&] { return imu.getNumSubscribers() > 0; }));
  const auto readings = messagesOf<sensor_msgs::Imu>(drive.bag(), "/imu");
  ASSERT_GT(readings.size(), 1000u);
  auto next = readings.begin();  // a second ahead of the scans, which would not wait for it
  constexpr std::ptrdiff_t kPiece = 100;
  for (auto begin = drive.clouds.begin(); begin != drive.clouds.end();) {
    const auto end = begin + std::min(kPiece, drive.clouds.end() - begin);
    const ros::Time until = end[-1]->header.stamp + ros::Duration(1.0);
    for (; next != readings.end() && (*next)->header.stamp <= until; ++next) imu.publish(*next);
    ASSERT_TRUE(slam.listener().diagnoses("gyro messages received",
                                          static_cast<int>(next - readings.begin())));
    slam.play({begin, end});
    begin = end;
  }
  ASSERT_TRUE(slam.trigger("back_end/finish").success);
  const TemporaryFolder folder;
  ASSERT_TRUE(slam.save(folder.file("saved")).success);
  EXPECT_EQ(textOf(folder.file("saved/trajectory.tum")), textOf(offline.results("trajectory.tum")));
}

}  // namespace
}  // namespace revisit_slam
