// SPDX-License-Identifier: MIT
#include <sensor_msgs/NavSatFix.h>
#include <tf2_ros/transform_listener.h>

#include "drive_with_loops.h"
#include "revisit_slam/geometry/local_enu.h"

namespace revisit_slam {
namespace {

const char* const kAntenna = "-0.6 0.3 -0.2";  // seen from the sensor, which is the base here

TEST(Gnss, aLiveDriveIsWhereTheOfflineProgramHasIt) {
  DriveWithLoops& drive = DriveWithLoops::get();
  const OfflineProgram offline(drive.bag(), {"--set", "frames/base=", "gnss/topic=/fix",
                                             std::string("gnss/antenna=") + kAntenna, "--quiet"});
  ASSERT_EQ(offline.status, 0) << offline.output;

  LiveSlam slam("gnss");
  for (const char* nodelet : {"odometry", "information", "map_manager", "back_end"}) {
    slam.set(nodelet, "gnss/topic", std::string("fix"));
    slam.set(nodelet, "gnss/antenna", std::string(kAntenna));
    slam.set(nodelet, "frames/earth", std::string("earth"));
  }
  tf2_ros::Buffer transforms;
  tf2_ros::TransformListener listener(transforms);
  ros::Publisher fixes = slam.node().advertise<sensor_msgs::NavSatFix>("fix", 1000);
  sensor_msgs::NavSatFix::ConstPtr datum;
  const ros::Subscriber subscriber = slam.node().subscribe<sensor_msgs::NavSatFix>(
      "datum", 1, [&](const sensor_msgs::NavSatFix::ConstPtr& message) { datum = message; });
  slam.load();
  ASSERT_TRUE(becomesTrue([&] { return fixes.getNumSubscribers() > 0; }));
  const auto positions = messagesOf<sensor_msgs::NavSatFix>(drive.bag(), "/fix");
  ASSERT_GT(positions.size(), 50u);
  for (const auto& position : positions) fixes.publish(position);  // as early as can be
  slam.play(drive.clouds);
  ASSERT_TRUE(slam.trigger("back_end/finish").success);
  const TemporaryFolder folder;
  ASSERT_TRUE(slam.save(folder.file("saved")).success);
  for (const char* name : {"trajectory.tum", "trajectory_enu.tum", "georeference.yaml"})
    EXPECT_EQ(textOf(folder.file(std::string("saved/") + name)), textOf(offline.results(name)))
        << name;

  ASSERT_TRUE(becomesTrue([&] { return datum != nullptr; }));
  const auto corrections = slam.copyOf(slam.corrections);
  const auto& georeference = corrections.back()->georeference;
  ASSERT_TRUE(georeference);
  EXPECT_EQ(datum->latitude, georeference->datum.latitude);
  const Pose T_earth_map = LocalEnu(georeference->datum).T_ecef_enu() * georeference->T_enu_map;
  EXPECT_TRUE(becomesTrue([&] {
    if (!transforms.canTransform("earth", "map", ros::Time(0))) return false;
    const Pose T = toPose(transforms.lookupTransform("earth", "map", ros::Time(0)).transform);
    return (T.translation - T_earth_map.translation).norm() < 1e-6;
  }));
}

}  // namespace
}  // namespace revisit_slam
