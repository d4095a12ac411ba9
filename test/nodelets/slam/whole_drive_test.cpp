// SPDX-License-Identifier: MIT
#include <tf2_ros/transform_listener.h>

#include <mutex>
#include <sstream>
#include <string>
#include <vector>

#include "drive_with_loops.h"
#include "revisit_slam/io/trajectory.h"

namespace revisit_slam {
namespace {

/// Without the last columns that name sessions: by the clock live, from 0 offline.
std::string withoutSessions(const std::string& table) {
  std::istringstream lines(table);
  std::string shortened;
  std::size_t named = 0;
  for (std::string line; std::getline(lines, line);) {
    if (shortened.empty())  // the header
      for (auto at = line.find("session"); at != line.npos; at = line.find("session", at + 1))
        ++named;
    for (std::size_t n = 0; n < named; ++n) line.erase(line.rfind(','));
    shortened += line + "\n";
  }
  return shortened;
}

TEST(WholeDrive, endsInTheFilesOfTheOfflineProgramAndLoopsCanBeDisabled) {
  DriveWithLoops& drive = DriveWithLoops::get();
  LiveSlam slam("whole_drive");
  tf2_ros::Buffer transforms;
  tf2_ros::TransformListener transform_listener(transforms);
  std::mutex mutex;
  std::vector<boost::shared_ptr<const MapUpdate>> seen_by_another;
  ros::NodeHandle other_node(slam.space());
  const ros::Subscriber another = other_node.subscribe<MapUpdate>(
      "submap", 0, [&](const boost::shared_ptr<const MapUpdate>& maps) {
        const std::lock_guard<std::mutex> lock(mutex);
        seen_by_another.push_back(maps);
      });
  slam.load();
  slam.play(drive.clouds);
  ASSERT_TRUE(slam.trigger("back_end/finish").success);
  const TemporaryFolder folder;
  const SaveMap::Response saved = slam.save(folder.file("saved"));
  ASSERT_TRUE(saved.success) << saved.message;
  EXPECT_EQ(saved.scans, drive.clouds.size());
  ASSERT_GE(saved.loops, 1u);

  for (const char* name : {"trajectory.tum", "trajectory_kitti.txt", "pose_graph.g2o",
                           "loop_closures.csv", "submaps/submaps.csv"})
    EXPECT_EQ(withoutSessions(textOf(folder.file(std::string("saved/") + name))),
              withoutSessions(textOf(drive.offline->results(name))))
        << name;
  EXPECT_GT(textOf(folder.file("saved/map.pcd")).size(), 100'000u);
  EXPECT_TRUE(slam.listener().drops().empty());

  // Every local map was searched, in order, and nothing was copied on the way.
  EXPECT_TRUE(becomesTrue([&] { return slam.copyOf(slam.maps).size() == saved.submaps; }));
  const auto maps = slam.copyOf(slam.maps);
  const auto second = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return seen_by_another;
  };
  ASSERT_TRUE(becomesTrue([&] { return second().size() == maps.size(); }));
  for (std::size_t i = 0; i < maps.size(); ++i) EXPECT_EQ(second()[i].get(), maps[i].get());
  std::vector<LocalMapPtr> closed;
  for (const auto& message : maps)
    if (message->local_map) closed.push_back(message->local_map);
  const auto searched = [&] {
    std::vector<LocalMapId> ids;
    for (const auto& closures : slam.copyOf(slam.loops))
      if (closures->origin == LoopOrigin::appearance) ids.push_back(closures->map);
    return ids;
  };
  ASSERT_TRUE(becomesTrue([&] { return searched().size() == closed.size(); }));
  for (std::size_t i = 0; i < closed.size(); ++i) EXPECT_EQ(searched()[i], closed[i]->id);

  // Corrections count from 1, and the last one is what TF says.
  const auto isBroadcast = [&](const Pose& T_map_odom) {
    if (!transforms.canTransform("map", "odom", ros::Time(0))) return false;
    const Pose T = toPose(transforms.lookupTransform("map", "odom", ros::Time(0)).transform);
    return (T.translation - T_map_odom.translation).norm() < 1e-9;
  };
  EXPECT_TRUE(becomesTrue([&] {
    const auto received = slam.copyOf(slam.corrections);
    return !received.empty() && isBroadcast(received.back()->T_map_odom);
  }));
  // Who begins to listen when no more scans come hears it, too.
  tf2_ros::Buffer late;
  const tf2_ros::TransformListener late_listener(late);
  EXPECT_TRUE(becomesTrue([&] { return late.canTransform("map", "odom", ros::Time(0)); }));

  const auto corrections = slam.copyOf(slam.corrections);
  for (std::size_t i = 0; i < corrections.size(); ++i) EXPECT_EQ(corrections[i]->version, i + 1);
  const Pose T_map_odom = corrections.back()->T_map_odom;
  EXPECT_GT(T_map_odom.translation.norm() + T_map_odom.angle(), 1e-6);

  // Without any loop the map is that of the odometry again.
  const std::size_t all = corrections.back()->loops.size();
  DisableLoop disable;
  for (std::uint32_t id = 0; id < all; ++id) {
    disable.request.loop = id;
    EXPECT_TRUE(slam.call("back_end/disable_loop", disable).response.success) << id;
  }
  EXPECT_FALSE(slam.call("back_end/disable_loop", disable).response.success);
  EXPECT_TRUE(becomesTrue([&] { return isBroadcast(Pose::identity()); }));
  ASSERT_TRUE(slam.save(folder.file("without")).success);
  const Trajectory without = readTum(folder.file("without/trajectory.tum"));
  const Trajectory odometry = readTum(drive.offline->results("odometry.tum"));
  ASSERT_EQ(without.size(), odometry.size());
  for (std::size_t i = 0; i < without.size(); ++i)
    EXPECT_LT((without[i].T_world_base.translation - odometry[i].T_world_base.translation).norm(),
              1e-6);
}

}  // namespace
}  // namespace revisit_slam
