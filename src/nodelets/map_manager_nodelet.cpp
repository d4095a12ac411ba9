// SPDX-License-Identifier: MIT
#include <revisit_slam/LiveLoopsConfig.h>
#include <revisit_slam/LiveRecognitionConfig.h>
#include <revisit_slam/LiveRetroactiveConfig.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "revisit_slam/ros/messages/scan_messages.h"
#include "revisit_slam/ros/node/live_parameters.h"
#include "revisit_slam/ros/node/map_display.h"
#include "revisit_slam/ros/node/slam_nodelet.h"
#include "revisit_slam/ros/node/stage_topics.h"
#include "revisit_slam/slam/map_manager.h"
#include "revisit_slam/util/process_usage.h"

namespace revisit_slam {

/// Hosts the map manager, and shows maps and loop search in rviz.
class MapManagerNodelet : public SlamNodelet {
 public:
  MapManagerNodelet() : SlamNodelet("maps") {}
  ~MapManagerNodelet() override {
    stopDiagnostics();
    for (ros::Subscriber* subscriber :
         {&scan_subscriber_, &request_subscriber_, &correction_subscriber_})
      subscriber->shutdown();
    live_loops_.reset();
    live_recognition_.reset();
    live_retroactive_.reset();
    if (building_) building_->stop();
    if (searching_) searching_->stop();
    display_.reset();
  }

 private:
  void start() override {
    ros::NodeHandle& node = getNodeHandle();
    closures_publisher_ = node.advertise<LoopClosures>("loop_constraints", 100);
    closed_publisher_ = node.advertise<MapsClosed>("maps_closed", 100);
    building_ = makeLane(config_.background.niceness);
    searching_ = makeLane(config_.background.niceness);
    stage_ = std::make_unique<MapManager>(config_, *building_, *searching_, outputs());
    searching_->post([this] {
      display_ = std::make_unique<MapDisplay>(getNodeHandle(), config_.frames.map, [this] {
        searching_->post([this] { display_->draw(); });
      });
    });
    startLiveParameters();
    const uint32_t depth = 0;  // no limit: none may be lost
    request_subscriber_ = node.subscribe<CloseMaps>(
        "close_maps", depth,
        [this](const boost::shared_ptr<const CloseMaps>& asked) { stage_->close(asked->request); });
    correction_subscriber_ = node.subscribe<MapCorrection>(
        "map_correction", depth, [this](const boost::shared_ptr<const MapCorrection>& correction) {
          place(toStdPointer(correction));
        });
    if (config_.mapping.enabled)
      scan_subscriber_ = node.subscribe<InformedScan>(
          "informed_scan", depth, [this](const boost::shared_ptr<const InformedScan>& informed) {
            stage_->insert(informed->scan);
          });
    maps_publisher_ = node.advertise<MapUpdate>("submap", 100);  // says that scans may come
  }

  MapManager::Outputs outputs() {
    MapManager::Outputs outputs;
    outputs.maps = [this](const MapUpdatePtr& maps) {
      maps_publisher_.publish(toBoostPointer(maps));
      ++submaps_;
      searching_->post([this, submap = maps->submap] { display_->add(submap); });
    };
    outputs.session = [this](SessionId session) { display_->startAnew(session); };
    outputs.loops.search = [this](const LoopSearchResult& search) { show(search); };
    outputs.loops.closures = [this](const LoopClosures& closures) {
      closures_publisher_.publish(boost::make_shared<const LoopClosures>(closures));
    };
    outputs.loops.closed = [this](const MapsClosed& closed) {
      closed_publisher_.publish(boost::make_shared<const MapsClosed>(closed));
    };
    outputs.loops.problem = [this](const std::string& problem) { noteError(problem); };
    return outputs;
  }

  void startLiveParameters() {
    const ros::NodeHandle& node = getPrivateNodeHandle();
    live_loops_ = std::make_unique<LiveParameters<LiveLoopsConfig, LoopsConfig>>(
        node, "loops", config_.loops, [this](const LoopsConfig& live) {
          stage_->reconfigure([live](LoopsConfig& loops, RetroactiveConfig&) {
            loops.closer.min_fitness = live.closer.min_fitness;
            loops.closer.min_coherence = live.closer.min_coherence;
          });
        });
    live_recognition_ =
        std::make_unique<LiveParameters<LiveRecognitionConfig, PlaceRecognitionConfig>>(
            node, "loops/recognition", config_.loops.recognition,
            [this](const PlaceRecognitionConfig& live) {
              stage_->reconfigure([live](LoopsConfig& loops, RetroactiveConfig&) {
                loops.recognition.min_inliers = live.min_inliers;
              });
            });
    live_retroactive_ = std::make_unique<LiveParameters<LiveRetroactiveConfig, RetroactiveConfig>>(
        node, "retroactive", config_.retroactive, [this](const RetroactiveConfig& live) {
          stage_->reconfigure(
              [live](LoopsConfig&, RetroactiveConfig& retroactive) { retroactive = live; });
        });
  }

  // In the lane that searches.

  void show(const LoopSearchResult& search) {
    const std::size_t accepted = search.accepted().size();
    loops_ += static_cast<int>(accepted);
    rejected_loops_ += static_cast<int>(search.proposals.size() - accepted);
    if (search.match && accepted > 0)
      NODELET_INFO("local map %u shows the place of %u: %zu loop constraints", search.map->id.value,
                   search.match->target.value, accepted);
    display_->add(search);
    display_->draw();
  }

  void place(const MapCorrectionPtr& correction) {
    stage_->correct(correction);
    searching_->post([this, correction] {
      display_->place(correction);
      display_->draw();
    });
  }

  // In the threads of the node.

  void diagnose(diagnostic_msgs::DiagnosticStatus& status) override {
    constexpr int most_waiting = 2;
    const MapManagerCount& count = stage_->count();
    const int missed = count.missed_scans, thinned = count.thinned_scans;
    const int maps_waiting = count.maps_waiting;
    const bool has_graph = correction_subscriber_.getNumPublishers() > 0;
    if (maps_waiting > 0 && !has_graph) stage_->giveUpWaiting();
    const bool is_behind = maps_waiting > most_waiting || thinned > reported_thinned_;
    status.level = is_behind || missed > reported_missed_ ? status.WARN : status.OK;
    status.message = is_behind                   ? "falling behind"
                     : missed > reported_missed_ ? "scans were missed; call odometry/reset"
                     : config_.mapping.enabled   ? "running"
                                                 : "switched off";
    reported_missed_ = missed;
    reported_thinned_ = thinned;
    addValue("scans waiting", std::to_string(building_->waiting()), status);
    addValue("scans missed", std::to_string(missed), status);
    addValue("scans without their points", std::to_string(thinned), status);
    addValue("submaps", std::to_string(submaps_), status);
    addValue("local maps waiting", std::to_string(maps_waiting), status);
    addValue("loops accepted", std::to_string(loops_), status);
    addValue("loops rejected", std::to_string(rejected_loops_), status);
    addValue("memory (MB)", std::to_string(memoryMegabytes()), status);
  }

  ros::Publisher maps_publisher_, closures_publisher_, closed_publisher_;
  std::unique_ptr<MapManager> stage_;
  std::unique_ptr<MapDisplay> display_;  // of the lane that searches
  std::atomic<int> submaps_{0}, loops_{0}, rejected_loops_{0};
  int reported_missed_ = 0, reported_thinned_ = 0;

  std::unique_ptr<ThreadLane> searching_, building_;
  ros::Subscriber scan_subscriber_, request_subscriber_, correction_subscriber_;
  std::unique_ptr<LiveParameters<LiveLoopsConfig, LoopsConfig>> live_loops_;
  std::unique_ptr<LiveParameters<LiveRecognitionConfig, PlaceRecognitionConfig>> live_recognition_;
  std::unique_ptr<LiveParameters<LiveRetroactiveConfig, RetroactiveConfig>> live_retroactive_;
};

}  // namespace revisit_slam

PLUGINLIB_EXPORT_CLASS(revisit_slam::MapManagerNodelet, nodelet::Nodelet)
