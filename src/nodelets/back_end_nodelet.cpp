// SPDX-License-Identifier: MIT
#include <revisit_slam/LiveBackEndConfig.h>
#include <revisit_slam/LiveLoopsConfig.h>
#include <revisit_slam/LiveRetroactiveConfig.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <filesystem>
#include <future>
#include <pluginlib/class_list_macros.hpp>

#include "graph_display.h"
#include "graph_services.h"
#include "graph_session.h"
#include "graph_status.h"
#include "map_broadcaster.h"
#include "occupancy_display.h"
#include "revisit_slam/util/work_queue.h"
#include "revisit_slam/util/niceness.h"
#include "revisit_slam/ros/node/live_parameters.h"
#include "revisit_slam/ros/node/session_messages.h"
#include "revisit_slam/ros/node/session_order.h"
#include "slam_nodelet.h"

namespace revisit_slam {

/// Keeps the pose graph, optimises it, searches retroactively and writes files, in a thread of its
/// own, in the order in which scans, maps and loops arrive.
class BackEndNodelet : public SlamNodelet {
 public:
  BackEndNodelet() : SlamNodelet("graph") {}
  ~BackEndNodelet() override {
    ending_ = true;
    stopDiagnostics();
    transform_timer_.stop();
    if (services_) services_->stop();
    for (ros::Subscriber* subscriber :
         {&scan_subscriber_, &maps_subscriber_, &loops_subscriber_, &closed_subscriber_})
      subscriber->shutdown();
    live_backend_.reset();
    live_loops_.reset();
    live_retroactive_.reset();
    if (!queue_) return;
    queue_->push([this] { endSession(); });
    queue_->drain();
    queue_->stop();
    display_.reset();
    occupancy_.reset();
  }

 private:
  using InformedScanPtr = boost::shared_ptr<const InformedScan>;
  using MapsPtr = boost::shared_ptr<const SessionMaps>;
  using LoopsPtr = boost::shared_ptr<const SessionLoops>;
  using ClosedPtr = boost::shared_ptr<const MapsClosed>;

  void start() override {
    ros::NodeHandle& node = getNodeHandle();
    working_config_ = config_;
    checkFolder();
    broadcaster_ = std::make_unique<MapBroadcaster>(config_.frames, config_.live);
    arena_.initialize(config_.background.threads);
    queue_ = std::make_unique<WorkQueue<std::function<void()>>>(
        std::numeric_limits<std::size_t>::max(),
        [this](const std::function<void()>& work) { doInArena(work); }, [] {});
    queue_->push([this] {
      setThreadNiceness(config_.background.niceness);
      display_ = std::make_unique<GraphDisplay>(getNodeHandle(), config_.frames.map,
                                                config_.backend.pulling_weight,
                                                [this] { queue_->push([this] { draw(); }); });
      occupancy_ = std::make_unique<OccupancyDisplay>(getNodeHandle(), config_.frames.map,
                                                      config_.occupancy,
                                                      [this] { queue_->push([this] { draw(); }); });
    });
    services_ = std::make_unique<GraphServices>(
        getPrivateNodeHandle(), [this](const GraphServices::Work& work) { doInWorker(work); },
        node.advertise<CloseMaps>("close_maps", 10));
    startLiveParameters();
    transform_timer_ = node.createWallTimer(ros::WallDuration(1.0 / config_.live.transform_rate),
                                            [this](const auto&) { broadcaster_->broadcast(); });

    const uint32_t depth = 0;  // no limit: none may be lost
    closed_subscriber_ = node.subscribe<MapsClosed>(
        "maps_closed", depth,
        [this](const ClosedPtr& closed) { queue_->push([this, closed] { handle(*closed); }); });
    loops_subscriber_ = node.subscribe<SessionLoops>(
        "loop_constraints", depth,
        [this](const LoopsPtr& loops) { queue_->push([this, loops] { handle(*loops); }); });
    maps_subscriber_ = node.subscribe<SessionMaps>("submap", depth, [this](const MapsPtr& maps) {
      queue_->push([this, maps] { handle(*maps); });
    });
    scan_subscriber_ = node.subscribe<InformedScan>(
        "informed_scan", depth, [this](const InformedScanPtr& scan) { take(*scan); });
    correction_publisher_ =  // says that scans may come
        node.advertise<SessionCorrection>("map_correction", 100);
  }

  void checkFolder() const {
    const std::string& folder = config_.live.folder;
    std::error_code error;
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (!error) return;
    NODELET_FATAL("live/folder is '%s', but cannot be made: %s", folder.c_str(),
                  error.message().c_str());
    throw ParameterError("live/folder");
  }

  void startLiveParameters() {
    const ros::NodeHandle& node = getPrivateNodeHandle();
    live_backend_ = std::make_unique<LiveParameters<LiveBackEndConfig, BackEndConfig>>(
        node, "backend", config_.backend, [this](const BackEndConfig& backend) {
          reconfigure([backend](SlamConfig& config) { config.backend = backend; });
        });
    live_loops_ = std::make_unique<LiveParameters<LiveLoopsConfig, LoopsConfig>>(
        node, "loops", config_.loops, [this](const LoopsConfig& loops) {
          reconfigure([loops](SlamConfig& config) { config.loops = loops; });
        });
    live_retroactive_ = std::make_unique<LiveParameters<LiveRetroactiveConfig, RetroactiveConfig>>(
        node, "retroactive", config_.retroactive, [this](const RetroactiveConfig& retroactive) {
          reconfigure([retroactive](SlamConfig& config) { config.retroactive = retroactive; });
        });
  }

  // In the worker.

  void doInArena(const std::function<void()>& work) {
    try {
      arena_.execute(work);
    } catch (const std::exception& error) {  // such as a full disk; what follows is done
      NODELET_ERROR("%s", error.what());
      status_.noteError(error.what());
    }
  }

  void handle(std::int64_t number, const GraphNode& node) {
    switch (order_.take(number, node.id)) {
      case ScanOrder::missed:
        NODELET_WARN_THROTTLE(5.0,
                              "no graph: scans before this one were missed; call odometry/reset");
        return;
      case ScanOrder::first:
        startSession(number, node.stamp);
        break;
      case ScanOrder::next:
        break;
    }
    if (!session_) return;
    session_->add(node);
    constexpr std::size_t scans_per_path = 10;
    if (session_->graph().size() % scans_per_path != 0) return;
    noteStatus();
    display_->drawPath(session_->graph());
  }

  /// The session before lives on until its last maps have come.
  void startSession(std::int64_t number, Stamp start) {
    if (session_) session_->writeGraph();
    before_ = std::move(session_);
    before_number_ = number_;
    number_ = number;
    session_ = std::make_unique<GraphSession>(working_config_, start,
                                              [this, number](const MapCorrectionPtr& correction) {
                                                publish({number, correction});
                                              });
    occupancy_->clear();
    if (!session_->folder().empty()) NODELET_INFO("writing to %s", session_->folder().c_str());
    noteStatus();
    draw();
  }

  GraphSession* find(std::int64_t number) const {
    if (session_ && number == number_) return session_.get();
    return before_ && number == before_number_ ? before_.get() : nullptr;
  }

  void handle(const SessionMaps& maps) {
    GraphSession* session = find(maps.session);
    if (!session) return;
    session->add(maps.maps);
    noteStatus();
  }

  void handle(const SessionLoops& loops) {
    GraphSession* session = find(loops.session);
    if (!session || ending_) return;
    session->add(loops.search);
    noteStatus();
    draw();
  }

  void handle(const MapsClosed& closed) {
    GraphSession* session = find(closed.session);
    if (!session) return services_->answer(closed.request, "there is nothing to finish");
    session->after(closed.scans, [this, session, closed] {
      std::string problem;
      try {
        session->finish();
      } catch (const std::exception& error) {
        problem = error.what();
        NODELET_ERROR("%s", problem.c_str());
      }
      noteStatus();
      draw();
      services_->answer(closed.request, problem);
    });
    if (session == before_.get()) before_.reset();
  }

  void publish(const SessionCorrection& correction) {
    if (correction.session != number_) return;
    broadcaster_->correct(correction.session, correction.correction->T_map_odom);
    correction_publisher_.publish(boost::make_shared<const SessionCorrection>(correction));
    status_.noteCorrection(*correction.correction);
  }

  void noteStatus() {
    if (session_) status_.note(*session_);
  }

  void draw() {
    if (!session_) return;
    display_->draw(session_->graph(), session_->submaps());
    occupancy_->draw(*session_);
  }

  void endSession() {
    if (session_) session_->writeGraph();
  }

  void reconfigure(const std::function<void(SlamConfig&)>& change) {
    queue_->push([this, change] {
      change(working_config_);
      if (session_) session_->backEnd().reconfigure(working_config_);
    });
  }

  // In the threads of the services.

  /// Waits until the worker has done this. @throws what it throws.
  void doInWorker(const GraphServices::Work& work) {
    std::packaged_task<void()> task([&] {
      work(session_.get());
      noteStatus();
      draw();
    });
    queue_->push([&task] { task(); });
    task.get_future().get();
  }

  // In the threads of the node.

  void take(const InformedScan& informed) {
    broadcaster_->onScan(informed.scan->session, informed.scan->stamp);
    queue_->push([this, session = informed.scan->session, node = nodeOf(informed)] {
      handle(session, node);
    });
  }

  void diagnose(diagnostic_msgs::DiagnosticStatus& status) override {
    status_.tell(queue_->waiting(), status);
  }

  ros::Publisher correction_publisher_;
  std::unique_ptr<MapBroadcaster> broadcaster_;
  std::atomic<bool> ending_{false};

  // Of the worker.
  tbb::task_arena arena_;
  SlamConfig working_config_;
  SessionOrder order_;
  std::int64_t number_ = 0, before_number_ = 0;
  std::unique_ptr<GraphSession> session_, before_;
  std::unique_ptr<GraphDisplay> display_;
  std::unique_ptr<OccupancyDisplay> occupancy_;

  GraphStatus status_;

  std::unique_ptr<WorkQueue<std::function<void()>>> queue_;
  ros::Subscriber scan_subscriber_, maps_subscriber_, loops_subscriber_, closed_subscriber_;
  ros::WallTimer transform_timer_;
  std::unique_ptr<GraphServices> services_;
  std::unique_ptr<LiveParameters<LiveBackEndConfig, BackEndConfig>> live_backend_;
  std::unique_ptr<LiveParameters<LiveLoopsConfig, LoopsConfig>> live_loops_;
  std::unique_ptr<LiveParameters<LiveRetroactiveConfig, RetroactiveConfig>> live_retroactive_;
};

}  // namespace revisit_slam

PLUGINLIB_EXPORT_CLASS(revisit_slam::BackEndNodelet, nodelet::Nodelet)
