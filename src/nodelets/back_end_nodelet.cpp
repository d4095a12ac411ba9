// SPDX-License-Identifier: MIT
#include <revisit_slam/LiveBackEndConfig.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <future>
#include <iterator>
#include <map>
#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "revisit_slam/ros/node/datum_topic.h"
#include "revisit_slam/ros/node/graph_display.h"
#include "revisit_slam/ros/node/graph_services.h"
#include "revisit_slam/ros/node/graph_status.h"
#include "revisit_slam/ros/node/live_parameters.h"
#include "revisit_slam/ros/node/map_broadcaster.h"
#include "revisit_slam/ros/node/occupancy_display.h"
#include "revisit_slam/ros/node/session_end.h"
#include "revisit_slam/ros/node/slam_nodelet.h"
#include "revisit_slam/ros/node/stage_topics.h"
#include "revisit_slam/session/drive_log.h"
#include "revisit_slam/slam/back_end.h"

namespace revisit_slam {

/// Hosts the back-end, broadcasts what it corrects, shows the graph and offers its services.
class BackEndNodelet : public SlamNodelet {
 public:
  BackEndNodelet() : SlamNodelet("graph") {}
  ~BackEndNodelet() override {
    ending_ = true;
    stopDiagnostics();
    transform_timer_.stop();
    if (services_) services_->stop();
    for (ros::Subscriber* subscriber :
         {&scan_subscriber_, &maps_subscriber_, &closures_subscriber_, &closed_subscriber_})
      subscriber->shutdown();
    live_parameters_.reset();
    if (!lane_) return;
    lane_->post([this] {
      for (GraphSession* session : stage_->sessions()) endUnasked(*session);
    });
    lane_->drain();
    lane_->stop();
    logging_->drain();
    logging_->stop();
    display_.reset();
    occupancy_.reset();
  }

 private:
  void start() override {
    ros::NodeHandle& node = getNodeHandle();
    requireWritable(config_.live);
    broadcaster_ = std::make_unique<MapBroadcaster>(config_.frames, config_.live);
    datum_ = std::make_unique<DatumTopic>(node);
    stage_ = std::make_unique<BackEnd>(
        config_, [this](const MapCorrectionPtr& correction) { publish(correction); },
        [this](SessionId session, Stamp start) {
          return liveTargets(config_.live, "frame " + sensor_frame_)(session, start);
        });
    logging_ = makeLane("log of scans", config_.background.niceness);
    lane_ = makeLane("graph", config_.background.niceness);
    std::promise<void> started;
    lane_->post([this, has_started = started.get_future().share()] {
      has_started.wait();  // nothing is answered before there is a publisher
      startDisplay();
    });
    services_ = std::make_unique<GraphServices>(
        getPrivateNodeHandle(), config_.live,
        [this](const GraphServices::Work& work) { doInLane(work); },
        node.advertise<CloseMaps>("close_maps", 10));
    live_parameters_ = std::make_unique<LiveParameters<LiveBackEndConfig, BackEndConfig>>(
        getPrivateNodeHandle(), "backend", config_.backend, [this](const BackEndConfig& config) {
          lane_->post([this, config] { stage_->reconfigure(config); });
        });
    transform_timer_ = node.createWallTimer(
        ros::WallDuration(1.0 / config_.live.transform_rate),
        [this](const auto&) { guarded([this] { broadcaster_->broadcast(); }); });
    subscribe(node);
    correction_publisher_ =  // says that scans may come
        node.advertise<MapCorrection>("map_correction", 100);
    started.set_value();
  }

  void subscribe(ros::NodeHandle& node) {
    const uint32_t depth = 0;  // no limit: none may be lost
    closed_subscriber_ = node.subscribe<MapsClosed>(
        "maps_closed", depth, [this](const boost::shared_ptr<const MapsClosed>& closed) {
          lane_->post([this, closed] { finish(*closed); });
        });
    closures_subscriber_ = node.subscribe<LoopClosures>(
        "loop_constraints", depth, [this](const boost::shared_ptr<const LoopClosures>& closures) {
          lane_->post([this, closures] { close(*closures); });
        });
    maps_subscriber_ = node.subscribe<MapUpdate>(
        "submap", depth, [this](const boost::shared_ptr<const MapUpdate>& maps) {
          lane_->post([this, maps = toStdPointer(maps)] { stage_->add(maps); });
        });
    scan_subscriber_ = node.subscribe<InformedScan>(
        "informed_scan", depth, [this](const boost::shared_ptr<const InformedScan>& informed) {
          guarded([&] { broadcaster_->onScan(*informed->scan); });
          lane_->post([this, node = nodeOf(*informed), frame = informed->scan->sensor_frame,
                       prior = informed->scan->goes_on_from,
                       entry = entryOf(*informed, informed->times)] {
            sensor_frame_ = frame;
            if (add(node, prior)) log(entry);
          });
        });
  }

  // In the lane.

  void startDisplay() {
    const auto draw_again = [this] { lane_->post([this] { draw(); }); };
    display_ = std::make_unique<GraphDisplay>(getNodeHandle(), config_, draw_again);
    occupancy_ = std::make_unique<OccupancyDisplay>(getNodeHandle(), config_.frames.map,
                                                    config_.occupancy, draw_again);
  }

  /// @return whether the scan is in the graph: not while the base stands still.
  bool add(const GraphNode& node, const KnownMapPtr& prior) {
    switch (stage_->add(node, prior)) {
      case ScanOrder::repeated:
        return false;
      case ScanOrder::missed:
        status_.noteMissedScan();
        NODELET_WARN_THROTTLE(5.0,
                              "no graph: scans before this one were missed; call odometry/reset");
        return false;
      case ScanOrder::first:
        occupancy_->clear();
        datum_->publish(std::nullopt);
        if (!stage_->session()->folder().empty())
          NODELET_INFO("writing to %s", stage_->session()->folder().c_str());
        draw();
        break;
      case ScanOrder::next:
        break;
    }
    constexpr std::size_t scans_per_path = 10;
    if (stage_->session()->graph().size() % scans_per_path != 0) return true;
    status_.note(*stage_->session());
    display_->drawPath(*stage_->session());
    return true;
  }

  /// Of the session that scans come from: the one before may end later than that begins. The graph
  /// does not wait for the disk.
  void log(const DriveLogEntry& entry) {
    const std::string& folder = stage_->session()->folder();
    if (folder.empty()) return;
    logging_->post([this, entry, folder] {
      logs_.try_emplace(entry.scan.session, folder).first->second.add(entry);
    });
  }

  void log(const LoopClosures& closures) {
    const SessionId id = closures.map.session;
    const GraphSession* session = stage_->find(id);
    if (session == nullptr || session->folder().empty()) return;
    logging_->post([this, id, folder = session->folder(), candidates = closures.candidates] {
      DriveLog& log = logs_.try_emplace(id, folder).first->second;
      for (const LoopCandidate& candidate : candidates) log.add(candidate);
    });
  }

  /// And no longer keeps those of sessions that have ended.
  std::string save(GraphSession& session) {
    logging_->drain();  // nobody else posts there
    const auto log = logs_.find(session.id());
    std::string problem = saveAll(session, log == logs_.end() ? nullptr : &log->second);
    for (auto other = logs_.begin(); other != logs_.end();)
      other = stage_->find(other->first) == nullptr ? logs_.erase(other) : std::next(other);
    return problem;
  }

  void close(const LoopClosures& closures) {
    if (ending_) return;
    stage_->add(closures);
    log(closures);
    draw();
  }

  void finish(const MapsClosed& closed) {
    stage_->add(closed, [this, request = closed.request](GraphSession* session,
                                                         const std::string& problem) {
      const std::string all = session == nullptr ? problem : save(*session);
      services_->answer(request, all, session == nullptr ? "" : session->folder());
      if (session != nullptr && !all.empty()) noteError(all);
    });
    draw();
  }

  void publish(const MapCorrectionPtr& correction) {
    correction_publisher_.publish(toBoostPointer(correction));
    if (correction->version == 0) return;
    broadcaster_->correct(*correction);
    datum_->publish(correction->georeference);
    status_.noteCorrection(*correction);
  }

  void draw() {
    if (!stage_->session()) return;
    status_.note(*stage_->session());
    display_->draw(*stage_->session());
    occupancy_->draw(*stage_->session());
  }

  // In the threads of the services.

  /// Waits until the lane has done this. @throws what it throws.
  void doInLane(const GraphServices::Work& work) {
    const auto task = std::make_shared<std::packaged_task<void()>>([&] {
      work(stage_->session());
      draw();
    });
    lane_->post([task] { (*task)(); });
    task->get_future().get();
  }

  // In the threads of the node.

  void diagnose(diagnostic_msgs::DiagnosticStatus& status) override {
    status_.tell(lane_->waiting(), status);
  }

  ros::Publisher correction_publisher_;
  std::unique_ptr<MapBroadcaster> broadcaster_;
  std::atomic<bool> ending_{false};
  GraphStatus status_;

  // Of the lane.
  std::string sensor_frame_;
  std::unique_ptr<DatumTopic> datum_;
  std::unique_ptr<BackEnd> stage_;
  std::unique_ptr<GraphDisplay> display_;
  std::unique_ptr<OccupancyDisplay> occupancy_;

  std::map<SessionId, DriveLog> logs_;  // of the lane that logs

  std::unique_ptr<ThreadLane> logging_, lane_;
  ros::Subscriber scan_subscriber_, maps_subscriber_, closures_subscriber_, closed_subscriber_;
  ros::WallTimer transform_timer_;
  std::unique_ptr<GraphServices> services_;
  std::unique_ptr<LiveParameters<LiveBackEndConfig, BackEndConfig>> live_parameters_;
};

}  // namespace revisit_slam

PLUGINLIB_EXPORT_CLASS(revisit_slam::BackEndNodelet, nodelet::Nodelet)
