// SPDX-License-Identifier: MIT
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <revisit_slam/LocalizationStatus.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <set>

#include "drive_with_loops.h"
#include "revisit_slam/io/trajectory.h"
#include "support/contains.h"

namespace revisit_slam {
namespace {

/// What a topic has told so far.
template <typename Message>
class Heard {
 public:
  Heard(LiveSlam& slam, const std::string& topic)
      : subscriber_(slam.node().subscribe<Message>(
            topic, 0, [this](const typename Message::ConstPtr& message) {
              const std::lock_guard<std::mutex> lock(mutex_);
              messages_.push_back(message);
            })) {}
  ~Heard() { subscriber_.shutdown(); }

  std::vector<typename Message::ConstPtr> all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<typename Message::ConstPtr> messages_;
  ros::Subscriber subscriber_;
};

/// Whether a status of the diagnostics came with this in its message.
bool isDiagnosed(const Heard<diagnostic_msgs::DiagnosticArray>& heard, const std::string& text) {
  for (const auto& array : heard.all())
    for (const diagnostic_msgs::DiagnosticStatus& status : array->status)
      if (status.level == status.WARN && contains(status.message, text)) return true;
  return false;
}

std::set<std::string> statesOf(const Heard<LocalizationStatus>& heard) {
  std::set<std::string> states;
  for (const auto& status : heard.all()) states.insert(status->state);
  return states;
}

std::map<std::string, std::string> filesOf(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "lock")
      files[std::filesystem::relative(entry.path(), folder).string()] =
          textOf(entry.path().string());
  return files;
}

/// The session that the offline program has left of the drive.
std::string savedMap() {
  return DriveWithLoops::get().offline->results("");
}

std::string onlyEntryOf(const std::string& folder) {
  std::vector<std::string> entries;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    entries.push_back(entry.path().string());
  EXPECT_EQ(entries.size(), 1u);
  return entries.empty() ? "" : entries.front();
}

TEST(ExtendingLive, givesTheFilesOfTheOfflineProgram) {
  DriveWithLoops& drive = DriveWithLoops::get();
  const auto map_before = filesOf(savedMap());
  const OfflineProgram offline(
      drive.bag(), {"--set", "frames/base=", "--quiet", "--mode", "extend", "--map", savedMap()});
  ASSERT_EQ(offline.status, 0) << offline.output;

  const TemporaryFolder folder;
  LiveSlam slam("extend", folder.file("drives"));
  slam.setAll("live/mode", std::string("extend"));
  slam.setAll("live/map", savedMap());
  const Heard<LocalizationStatus> states(slam, "localization");
  const Heard<sensor_msgs::PointCloud2> prior(slam, "prior_map");
  tf2_ros::Buffer transforms;
  tf2_ros::TransformListener listener(transforms);
  slam.load();
  slam.play({drive.clouds.begin(), drive.clouds.begin() + 60});
  EXPECT_TRUE(becomesTrue([&] { return !states.all().empty(); }));
  EXPECT_EQ(statesOf(states), std::set<std::string>{"searching"});
  EXPECT_FALSE(transforms.canTransform("map", "odom", ros::Time(0)));
  slam.play({drive.clouds.begin() + 60, drive.clouds.end()});
  const auto finished = slam.trigger("back_end/finish");
  ASSERT_TRUE(finished.success) << finished.message;
  EXPECT_TRUE(becomesTrue([&] { return statesOf(states).count("localized") > 0; }));
  EXPECT_TRUE(becomesTrue([&] { return transforms.canTransform("map", "odom", ros::Time(0)); }));
  EXPECT_TRUE(
      becomesTrue([&] { return !prior.all().empty() && prior.all().back()->width > 1000; }));

  const std::string live = onlyEntryOf(folder.file("drives")) + "/";
  for (const char* name : {"odometry.tum", "odometry_information.csv", "trajectory_0.tum",
                           "trajectory_1.tum", "pose_graph.g2o", "loop_closures.csv",
                           "loop_candidates.csv", "graph.log", "optimisations.log", "map.pcd",
                           "submaps/submaps.csv", "submaps/000000.rsm", "submaps/1_000000.rsm"})
    EXPECT_TRUE(textOf(live + name) == textOf(offline.results(name))) << name;
  EXPECT_TRUE(filesOf(savedMap()) == map_before);
}

TEST(ExtendingLive, beginsOnRequestAndIsRefusedWithTheReason) {
  const TemporaryFolder folder;
  LiveSlam slam("load", folder.file("drives"));
  slam.load();
  const auto& clouds = DriveWithLoops::get().clouds;
  slam.play({clouds.begin(), clouds.begin() + 60});
  const std::string running = onlyEntryOf(folder.file("drives"));
  std::filesystem::create_directory(folder.file("none"));
  const std::map<std::string, std::string> reasons{{"", "no map"},
                                                   {"nowhere", "is no session"},
                                                   {folder.file("none"), "is no session"},
                                                   {running, "is being written"}};
  for (const auto& [map, reason] : reasons) {
    const LoadMap::Response refused = slam.loadMap("odometry", map);
    EXPECT_FALSE(refused.success) << map;
    EXPECT_TRUE(contains(refused.message, "nothing has changed")) << refused.message;
    EXPECT_TRUE(contains(refused.message, reason)) << refused.message;
  }
  slam.play({clouds.begin() + 60, clouds.begin() + 120});  // in the same session
  const LoadMap::Response loaded = slam.loadMap("odometry", savedMap());
  ASSERT_TRUE(loaded.success) << loaded.message;
  EXPECT_GT(loaded.submaps, 20u);
  EXPECT_GT(loaded.places, 3u);
  slam.play({clouds.begin(), clouds.begin() + 200});
  ASSERT_TRUE(slam.trigger("back_end/finish").success);
  EXPECT_EQ(readTum(running + "/trajectory.tum").size(), 120u);
  const std::string extended = running + "_2";
  EXPECT_TRUE(contains(textOf(extended + "/session.yaml"), "joined"));
  EXPECT_EQ(textOf(extended + "/submaps/000000.rsm"), textOf(savedMap() + "/submaps/000000.rsm"));
}

TEST(LocalizingLive, findsTheDriveInTheMapAndTakesAnother) {
  DriveWithLoops& drive = DriveWithLoops::get();
  const Trajectory truth = readTum(drive.offline->results("trajectory.tum"));
  const OfflineProgram offline(
      drive.bag(), {"--set", "frames/base=", "--quiet", "--mode", "localize", "--map", savedMap()});
  ASSERT_EQ(offline.status, 0) << offline.output;
  const TemporaryFolder folder;
  LiveSlam slam("localize", folder.file("drives"));
  const Heard<LocalizationStatus> states(slam, "localization");
  const Heard<geometry_msgs::PoseWithCovarianceStamped> poses(slam, "localized_pose");
  const Heard<sensor_msgs::PointCloud2> prior(slam, "prior_map");
  const Heard<visualization_msgs::Marker> texts(slam, "localization_text");
  const Heard<diagnostic_msgs::DiagnosticArray> diagnostics(slam, "/diagnostics");
  slam.loadLocalization(savedMap());
  std::filesystem::remove_all(folder.file("drives"));
  std::ofstream(folder.file("drives")) << "no folder";
  const auto tenth = drive.clouds.begin() + static_cast<std::ptrdiff_t>(drive.clouds.size() / 10);
  const auto half = drive.clouds.begin() + static_cast<std::ptrdiff_t>(drive.clouds.size() / 2);
  slam.play({drive.clouds.begin(), tenth});
  EXPECT_TRUE(becomesTrue(
      [&] { return isDiagnosed(diagnostics, "not on disk, and is tried again: cannot write"); }));
  std::filesystem::remove(folder.file("drives"));  // none of what waited is lost
  slam.play({tenth, half});
  ASSERT_TRUE(becomesTrue([&] { return statesOf(states).count("localized") > 0; }));
  ASSERT_TRUE(becomesTrue([&] { return poses.all().size() > 100; }));
  const std::string live = onlyEntryOf(folder.file("drives")) + "/";
  for (const char* name : {"localized.tum", "localization.csv"}) {
    const std::string lines = textOf(live + name);
    EXPECT_GT(lines.size(), 10'000u) << name;
    EXPECT_EQ(textOf(offline.results(name)).substr(0, lines.size()), lines) << name;
  }
  EXPECT_TRUE(becomesTrue([&] { return !prior.all().empty(); }));
  EXPECT_TRUE(
      becomesTrue([&] { return !texts.all().empty() && texts.all().back()->text == "localized"; }));
  std::map<std::int64_t, Eigen::Vector3d> expected;
  for (const StampedPose& pose : truth)
    expected[pose.stamp.nanoseconds] = pose.T_world_base.translation;
  for (const auto& pose : poses.all()) {
    const geometry_msgs::Point& p = pose->pose.pose.position;
    const auto stamp = static_cast<std::int64_t>(pose->header.stamp.toNSec());
    ASSERT_EQ(expected.count(stamp), 1u);
    EXPECT_LT((Eigen::Vector3d(p.x, p.y, p.z) - expected[stamp]).norm(), 0.3);
  }

  EXPECT_FALSE(slam.loadMap("localization", "/nowhere").success);
  const LoadMap::Response loaded = slam.loadMap("localization", savedMap());
  ASSERT_TRUE(loaded.success) << loaded.message;
  EXPECT_GT(loaded.places, 3u);
  ASSERT_TRUE(becomesTrue([&] { return states.all().back()->state == "searching"; }));
  // Where it is drawn, it is found at once.
  const Pose& here = truth[drive.clouds.size() / 2 - 1].T_world_base;
  ros::Publisher drawn =
      slam.node().advertise<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 1);
  ASSERT_TRUE(becomesTrue([&] { return drawn.getNumSubscribers() > 0; }));
  geometry_msgs::PoseWithCovarianceStamped pose;
  pose.header.frame_id = "map";
  pose.pose.pose = toPoseMessage(here);
  drawn.publish(pose);
  slam.play({half, half + 60});
  EXPECT_TRUE(becomesTrue([&] { return states.all().back()->state == "localized"; }));
  slam.unload();
  std::size_t scans = 0;  // each in the log of the map in which it was localized
  for (const auto& entry : std::filesystem::directory_iterator(folder.file("drives"))) {
    const std::string log = textOf(entry.path().string() + "/localization.csv");
    const auto lines = static_cast<std::size_t>(std::count(log.begin(), log.end(), '\n'));
    EXPECT_LE(lines, drive.clouds.size() / 2 + 1) << entry.path();
    scans += lines - 1;
  }
  EXPECT_EQ(scans, drive.clouds.size() / 2 + 60);
}

}  // namespace
}  // namespace revisit_slam
