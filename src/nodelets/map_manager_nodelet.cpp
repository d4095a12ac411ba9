// SPDX-License-Identifier: MIT
#include <revisit_slam/LiveLoopsConfig.h>
#include <revisit_slam/LiveRecognitionConfig.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "map_display.h"
#include "revisit_slam/util/work_queue.h"
#include "revisit_slam/util/process_usage.h"
#include "revisit_slam/loops/search/loop_search.h"
#include "revisit_slam/slam/map_builder.h"
#include "revisit_slam/util/niceness.h"
#include "revisit_slam/ros/node/live_parameters.h"
#include "revisit_slam/ros/messages/scan_messages.h"
#include "revisit_slam/ros/node/session_messages.h"
#include "revisit_slam/ros/node/session_order.h"
#include "slam_nodelet.h"

namespace revisit_slam {

/// Builds submaps and local maps in one thread, and searches each closed local map for loops in
/// another, which also draws.
class MapManagerNodelet : public SlamNodelet {
 public:
  MapManagerNodelet() : SlamNodelet("maps") {}
  ~MapManagerNodelet() override {
    stopDiagnostics();
    scan_subscriber_.shutdown();
    request_subscriber_.shutdown();
    correction_subscriber_.shutdown();
    live_loops_.reset();
    live_recognition_.reset();
    if (building_) building_->stop();
    if (searching_) searching_->stop();
    display_.reset();
  }

 private:
  using Queue = WorkQueue<std::function<void()>>;
  using InformedScanPtr = boost::shared_ptr<const InformedScan>;
  using MapsPtr = boost::shared_ptr<const SessionMaps>;
  using CorrectionPtr = boost::shared_ptr<const SessionCorrection>;

  void start() override {
    ros::NodeHandle& node = getNodeHandle();
    loops_publisher_ = node.advertise<SessionLoops>("loop_constraints", 100);
    closed_publisher_ = node.advertise<MapsClosed>("maps_closed", 100);

    building_ = makeQueue();
    searching_ = makeQueue();
    arena_.initialize(config_.background.threads);
    loops_config_ = config_.loops;
    searching_->push([this] {
      display_ = std::make_unique<MapDisplay>(getNodeHandle(), config_.frames.map, [this] {
        searching_->push([this] { display_->draw(); });
      });
    });
    live_loops_ = std::make_unique<LiveParameters<LiveLoopsConfig, LoopsConfig>>(
        getPrivateNodeHandle(), "loops", config_.loops, [this](const LoopsConfig& config) {
          searching_->push([this, config] { reconfigure(config.closer); });
        });
    live_recognition_ =
        std::make_unique<LiveParameters<LiveRecognitionConfig, PlaceRecognitionConfig>>(
            getPrivateNodeHandle(), "loops/recognition", config_.loops.recognition,
            [this](const PlaceRecognitionConfig& config) {
              searching_->push([this, config] { reconfigure(config); });
            });

    const uint32_t depth = 0;  // no limit: none may be lost
    request_subscriber_ = node.subscribe<CloseMaps>(
        "close_maps", depth, [this](const boost::shared_ptr<const CloseMaps>& asked) {
          building_->push([this, asked] { closeMaps(asked->request); });
        });
    correction_subscriber_ = node.subscribe<SessionCorrection>(
        "map_correction", depth, [this](const CorrectionPtr& correction) {
          searching_->push([this, correction] { place(*correction); });
        });
    if (config_.mapping.enabled)
      scan_subscriber_ =
          node.subscribe<InformedScan>("informed_scan", depth, [this](const InformedScanPtr& scan) {
            building_->push([this, scan] { insert(*scan->scan); });
          });
    maps_publisher_ = node.advertise<SessionMaps>("submap", 100);  // says that scans may come
  }

  std::unique_ptr<Queue> makeQueue() {
    auto queue = std::make_unique<Queue>(
        std::numeric_limits<std::size_t>::max(), [](const std::function<void()>& work) { work(); },
        [] {});
    queue->push([this] { setThreadNiceness(config_.background.niceness); });
    return queue;
  }

  // In the thread that builds.

  void insert(const RegisteredScan& scan) {
    const std::uint32_t scans_before = order_.scans();
    switch (order_.take(scan.session, scan.id)) {
      case ScanOrder::missed:
        ++missed_scans_;
        NODELET_WARN_THROTTLE(5.0,
                              "no maps: scans before this one were missed; call odometry/reset");
        return;
      case ScanOrder::first:
        if (scans_before > 0) closeMaps(0, scans_before);
        session_ = scan.session;
        builder_ = std::make_unique<MapBuilder>(config_.mapping, config_.occupancy);
        searching_->push([this, session = session_] { startSearches(session); });
        break;
      case ScanOrder::next:
        break;
    }
    hand(builder_->insert(scan));
  }

  void closeMaps(std::uint32_t request) { closeMaps(request, order_.scans()); }

  void closeMaps(std::uint32_t request, std::uint32_t scans) {
    if (builder_) hand(builder_->closeAll());
    MapsClosed closed;
    closed.session = session_;
    closed.scans = scans;
    closed.request = request;
    searching_->push([this, closed] {
      closed_publisher_.publish(boost::make_shared<const MapsClosed>(closed));
    });
  }

  void hand(MapUpdate update) {
    if (!update.submap) return;
    const auto maps =
        boost::make_shared<const SessionMaps>(SessionMaps{session_, std::move(update)});
    maps_publisher_.publish(maps);
    ++submaps_;
    if (maps->maps.local_map) ++maps_waiting_;
    searching_->push([this, session = maps->session, submap = maps->maps.submap,
                      map = maps->maps.local_map] { show(session, submap, map); });
  }

  // In the thread that searches.

  void startSearches(std::int64_t session) {
    shown_session_ = session;
    search_ = std::make_unique<LoopSearch>(loops_config_, config_.information);
    display_->startAnew();
  }

  void show(std::int64_t session, const SubmapPtr& submap, const LocalMapPtr& map) {
    display_->add(submap);
    if (map) {
      auto result = arena_.execute([&] { return search_->search(map); });
      const auto loops =
          boost::make_shared<const SessionLoops>(SessionLoops{session, std::move(result)});
      loops_publisher_.publish(loops);
      --maps_waiting_;
      count(loops->search);
      display_->add(loops->search);
    }
    display_->draw();
  }

  void count(const LoopSearchResult& search) {
    ++maps_;
    const std::size_t accepted = search.accepted().size();
    loops_ += static_cast<int>(accepted);
    rejected_loops_ += static_cast<int>(search.proposals.size() - accepted);
    if (accepted > 0)
      NODELET_INFO("local map %u shows the place of %u: %zu loop constraints", search.map->id.value,
                   search.match->target.value, accepted);
  }

  void place(const SessionCorrection& correction) {
    if (correction.session != shown_session_) return;
    display_->place(correction.correction);
    display_->draw();
  }

  void reconfigure(const LoopCloserConfig& closer) {
    loops_config_.closer.min_fitness = closer.min_fitness;
    loops_config_.closer.min_coherence = closer.min_coherence;
    if (search_) search_->reconfigure(loops_config_);
  }

  void reconfigure(const PlaceRecognitionConfig& recognition) {
    loops_config_.recognition.min_inliers = recognition.min_inliers;
    if (search_) search_->reconfigure(loops_config_);
  }

  // In the threads of the node.

  void diagnose(diagnostic_msgs::DiagnosticStatus& status) override {
    constexpr int most_waiting = 2;
    const int waiting = maps_waiting_, missed = missed_scans_;
    const bool behind = waiting > most_waiting;
    status.level = behind || missed > reported_misses_ ? status.WARN : status.OK;
    status.message = behind                      ? "falling behind"
                     : missed > reported_misses_ ? "scans were missed"
                     : config_.mapping.enabled   ? "running"
                                                 : "switched off";
    reported_misses_ = missed;
    addValue("scans waiting", std::to_string(building_->waiting()), status);
    addValue("scans missed", std::to_string(missed), status);
    addValue("submaps", std::to_string(submaps_), status);
    addValue("local maps", std::to_string(maps_), status);
    addValue("local maps waiting", std::to_string(waiting), status);
    addValue("loops accepted", std::to_string(loops_), status);
    addValue("loops rejected", std::to_string(rejected_loops_), status);
    addValue("memory (MB)", std::to_string(memoryMegabytes()), status);
  }

  ros::Publisher maps_publisher_, loops_publisher_, closed_publisher_;

  // Of the thread that builds.
  SessionOrder order_;
  std::int64_t session_ = 0;
  std::unique_ptr<MapBuilder> builder_;

  // Of the thread that searches.
  tbb::task_arena arena_;
  LoopsConfig loops_config_;
  std::unique_ptr<LoopSearch> search_;
  std::unique_ptr<MapDisplay> display_;
  std::int64_t shown_session_ = 0;

  std::atomic<int> missed_scans_{0}, submaps_{0}, maps_{0}, maps_waiting_{0}, loops_{0},
      rejected_loops_{0};
  int reported_misses_ = 0;

  std::unique_ptr<Queue> searching_, building_;
  ros::Subscriber scan_subscriber_, request_subscriber_, correction_subscriber_;
  std::unique_ptr<LiveParameters<LiveLoopsConfig, LoopsConfig>> live_loops_;
  std::unique_ptr<LiveParameters<LiveRecognitionConfig, PlaceRecognitionConfig>> live_recognition_;
};

}  // namespace revisit_slam

PLUGINLIB_EXPORT_CLASS(revisit_slam::MapManagerNodelet, nodelet::Nodelet)
