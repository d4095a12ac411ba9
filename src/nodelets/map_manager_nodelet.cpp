// SPDX-License-Identifier: MIT
#include <revisit_slam/LiveLoopsConfig.h>
#include <revisit_slam/LiveRecognitionConfig.h>
#include <revisit_slam/LiveRetroactiveConfig.h>

#include <boost/make_shared.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "revisit_slam/ros/node/live_parameters.h"
#include "revisit_slam/ros/node/map_display.h"
#include "revisit_slam/ros/node/map_status.h"
#include "revisit_slam/ros/node/slam_nodelet.h"
#include "revisit_slam/ros/node/stage_topics.h"
#include "revisit_slam/slam/map_manager.h"

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
    building_ = makeLane("maps", config_.background.niceness);
    searching_ = makeLane("loops", config_.background.niceness);
    stage_ = std::make_unique<MapManager>(config_, *building_, *searching_, outputs());
    searching_->post([this] {
      display_ = std::make_unique<MapDisplay>(
          getNodeHandle(), config_, [this] { searching_->post([this] { display_->draw(); }); });
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
            stage_->insert(*informed);
          });
    maps_publisher_ = node.advertise<MapUpdate>("submap", 100);  // says that scans may come
  }

  MapManager::Outputs outputs() {
    MapManager::Outputs outputs;
    outputs.maps = [this](const MapUpdatePtr& maps) {
      maps_publisher_.publish(toBoostPointer(maps));
      status_.addSubmap();
      searching_->post([this, submap = maps->submap, library = maps->library] {
        display_->add(submap, library);
      });
    };
    outputs.session = [this](SessionId session, const KnownMapPtr& prior) {
      display_->startAnew(session, prior);
    };
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
    status_.add(search);
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
    const bool has_graph = correction_subscriber_.getNumPublishers() > 0;
    if (stage_->count().maps_waiting > 0 && !has_graph) stage_->giveUpWaiting();
    status_.tell(stage_->count(), building_->waiting(), config_.mapping.enabled, status);
  }

  ros::Publisher maps_publisher_, closures_publisher_, closed_publisher_;
  std::unique_ptr<MapManager> stage_;
  std::unique_ptr<MapDisplay> display_;  // of the lane that searches
  MapStatus status_;

  std::unique_ptr<ThreadLane> searching_, building_;
  ros::Subscriber scan_subscriber_, request_subscriber_, correction_subscriber_;
  std::unique_ptr<LiveParameters<LiveLoopsConfig, LoopsConfig>> live_loops_;
  std::unique_ptr<LiveParameters<LiveRecognitionConfig, PlaceRecognitionConfig>> live_recognition_;
  std::unique_ptr<LiveParameters<LiveRetroactiveConfig, RetroactiveConfig>> live_retroactive_;
};

}  // namespace revisit_slam

PLUGINLIB_EXPORT_CLASS(revisit_slam::MapManagerNodelet, nodelet::Nodelet)
