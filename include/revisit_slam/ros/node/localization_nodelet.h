// SPDX-License-Identifier: MIT
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "revisit_slam/localization/localization_log.h"
#include "revisit_slam/ros/node/datum_topic.h"
#include "revisit_slam/ros/node/map_broadcaster.h"
#include "revisit_slam/ros/node/map_loader.h"
#include "revisit_slam/ros/node/prior_cloud.h"
#include "revisit_slam/ros/node/slam_nodelet.h"
#include "revisit_slam/slam/localization_stage.h"

namespace revisit_slam {

/// Hosts localization in the map of an earlier session, in the place of map manager and back-end.
/// Broadcasts map to odom as soon as it is known.
class LocalizationNodelet : public SlamNodelet {
 public:
  LocalizationNodelet() : SlamNodelet("localization") {}
  ~LocalizationNodelet() override;

 private:
  void start() override;
  void advertise(ros::NodeHandle& node);
  void subscribe(ros::NodeHandle& node);
  void diagnose(diagnostic_msgs::DiagnosticStatus& status) override;
  std::unique_ptr<LocalizationStage> readMap(const std::string& folder,
                                             const std::string& start) const;
  void load(const std::string& folder, LoadMap::Response& response);
  void postThinned(InformedScan informed);
  std::size_t mostWaiting() const;

  // In the lane.
  void add(const InformedScan& informed);
  void change(std::unique_ptr<LocalizationStage> stage);
  void write(const Localization& now);
  void endLog();
  void publish(const Localization& now);
  void tellWhereOnEarth();
  void startAt(const geometry_msgs::PoseWithCovarianceStamped& drawn);
  void drawMapIfWanted();
  void drawMap();
  void drawTarget(const std::optional<SubmapId>& target) const;
  void drawState(const Localization& now) const;

  std::unique_ptr<LocalizationStage> stage_;  // of the lane
  std::optional<PriorCloud> cloud_;           // of its map; of the lane; none: not drawn yet
  std::unique_ptr<MapBroadcaster> broadcaster_;
  std::unique_ptr<DatumTopic> datum_;   // of the lane
  std::optional<LocalizationLog> log_;  // of the lane; where live/folder is given
  SessionId logged_;                    // whose it is
  std::string log_folder_;

  std::atomic<std::size_t> thinned_scans_{0};
  std::mutex mutex_;  // guards the next two
  Localization last_;
  std::string log_problem_;  // why what is logged waits; empty: it does not

  std::unique_ptr<ThreadLane> lane_;
  std::unique_ptr<MapLoader> loader_;
  ros::Publisher status_publisher_, pose_publisher_, map_publisher_, target_publisher_,
      text_publisher_;
  ros::Subscriber scan_subscriber_, start_subscriber_;
  ros::WallTimer transform_timer_;
};

}  // namespace revisit_slam
