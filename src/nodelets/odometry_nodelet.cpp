// SPDX-License-Identifier: MIT
#include <revisit_slam/LiveOdometryConfig.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <pluginlib/class_list_macros.hpp>
#include <utility>
#include <variant>

#include "revisit_slam/ros/messages/scan_messages.h"
#include "revisit_slam/ros/node/input_report.h"
#include "revisit_slam/ros/node/live_parameters.h"
#include "revisit_slam/ros/node/map_to_extend_loader.h"
#include "revisit_slam/ros/node/motion_subscription.h"
#include "revisit_slam/ros/node/odometry_report.h"
#include "revisit_slam/ros/node/odometry_topics.h"
#include "revisit_slam/ros/node/scan_subscription.h"
#include "revisit_slam/ros/node/sensor_placement.h"
#include "revisit_slam/ros/node/slam_nodelet.h"
#include "revisit_slam/slam/odometry_stage.h"
#include "revisit_slam/util/work_queue.h"

namespace revisit_slam {

/// Hosts the odometry: read, register, broadcast. Scans wait in a queue of its own, so that the
/// number that the odometry could not take is known.
class OdometryNodelet : public SlamNodelet {
 public:
  OdometryNodelet() : SlamNodelet("odometry") {}
  ~OdometryNodelet() override {
    stopDiagnostics();
    flush_timer_.stop();
    if (scans_) scans_->unsubscribe();
    if (motions_) motions_->unsubscribe();
    reset_service_.shutdown();
    if (loader_) loader_->stop();
    live_parameters_.reset();
    if (queue_) queue_->stop();  // not reset(): its thread looks at queue_ until it ends
  }

 private:
  static constexpr std::uint32_t kScansPerCheck = 50;  // of TF

  struct Flush {};   // no further scan comes
  struct Motion {};  // look into the inbox, as before every other message
  using Message = std::variant<ArrivedScan, Flush, Motion>;

  void start() override {
    ros::NodeHandle& node = getNodeHandle();
    ros::NodeHandle& private_node = getPrivateNodeHandle();
    const SessionId now{static_cast<std::uint32_t>(ros::WallTime::now().sec)};
    scans_ = std::make_unique<ScanSubscription>(config_.input);
    motions_ = std::make_unique<MotionSubscription>(
        config_.priors, config_.gnss, [this](const std::string& frame) { return place(frame); });
    stage_ = std::make_unique<OdometryStage>(config_, now, mapToExtend(config_));
    placement_ =
        std::make_unique<SensorPlacement>(config_.frames.base, config_.live.transform_patience);

    topics_ = std::make_unique<OdometryTopics>(node, config_);
    reset_service_ = private_node.advertiseService("reset", &OdometryNodelet::reset, this);
    loader_ = loadMapsToExtend(private_node, config_, [this](const KnownMapPtr& map) {
      const std::lock_guard<std::mutex> lock(mutex_);
      next_map_ = map;
      reset_requested_ = true;
    });
    live_parameters_ = std::make_unique<LiveParameters<LiveOdometryConfig, OdometryConfig>>(
        private_node, "odometry", config_.odometry, [this](const OdometryConfig& config) {
          const std::lock_guard<std::mutex> lock(mutex_);
          stage_->reconfigure(config);
        });
    queue_ = std::make_unique<WorkQueue<Message>>(
        config_.live.queue_size,
        [this](const Message& message) { guarded([&] { handle(message); }); },
        [this] { onQueueFull(); });
    watchLoad("busy with odometry", [this] { return queue_->busySeconds(); });
    motions_->subscribe(node, [this] {
      if (queue_->waiting() == 0) queue_->push(Motion{});
    });
    scans_->subscribe(
        node, [this](const ArrivedScan& scan) { queue_->push(scan); },
        [this](const std::string& fault) { onDamaged(fault); });
    flush_timer_ = node.createWallTimer(ros::WallDuration(0.25), [this](const auto&) {
      guarded([this] { flushWhereNoneComes(); });
    });
  }

  // In the thread of the queue.

  void handle(const Message& message) {
    countUncounted();
    startSessionIfAsked();
    if (!placement_->baseFrame().empty()) takeMotion();
    std::visit([this](const auto& what) { take(what); }, message);
  }

  void take(Motion) {}

  void takeMotion() {
    for (const MotionReader::Result& read : motions_->readAll())
      finish([&] {
        if (read.reading) return stage_->takeMotion(*read.reading);
        stage_->countDroppedMotion(read.sensor, read.rejection);
        return std::vector<OdometryStage::Result>();
      });
  }

  std::optional<Pose> place(const std::string& frame) {
    return placement_->find(
        frame, [this] { return queue_->stopping() || reset_requested_ || newestIsPlaced(); });
  }

  void take(Flush) {
    finish([&] { return stage_->flush(); });
  }

  void take(const ArrivedScan& arrived) {
    StageClock clock;
    ScanReading reading = scans_->read(arrived);
    if (reading.scan) {
      const std::optional<Pose> T_base_sensor = place(reading.frame_id);
      if (!T_base_sensor) return drop("no transform from '" + reading.frame_id + "'");
      reading.scan->T_base_sensor = *T_base_sensor;
    }
    const bool registered = finish([&] { return stage_->process(std::move(reading)); });
    clock.stage("scan");
    const std::lock_guard<std::mutex> lock(mutex_);
    if (registered) numbers_.noteTime(clock.times().back().second);
  }

  /// Scans of a frame that is known do not wait for one that may never be.
  bool newestIsPlaced() const {
    const std::optional<Message> newest = queue_->newest();
    const ArrivedScan* scan = newest ? std::get_if<ArrivedScan>(&*newest) : nullptr;
    return scan && placement_->knows(scan->frame());
  }

  /// What was asked for and with which map: both or neither.
  void startSessionIfAsked() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!reset_requested_.exchange(false)) return;
    placement_->restart();
    stage_->startSession(std::exchange(next_map_, nullptr));
    numbers_.restart();
  }

  /// What the stage made of what it was given. @return whether the last of it was registered.
  template <typename Give>
  bool finish(const Give& give) {
    std::vector<OdometryStage::Result> results;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      results = give();
    }
    for (const OdometryStage::Result& result : results) tell(result);
    return !results.empty() && results.back().output.scan;
  }

  void tell(const OdometryStage::Result& result) {
    if (!result.notice.empty()) NODELET_WARN("%s", result.notice.c_str());
    note(result);
    if (!result.output.scan) {
      NODELET_WARN_THROTTLE(5.0, "scan dropped: %s", result.rejection.c_str());
      return;
    }
    if (result.output.scan->id.value % kScansPerCheck == 0) checkBroadcast();
    topics_->publish(result.output, placement_->baseFrame());
    const RegistrationResult& registration = result.output.scan->registration;
    if (registration.outcome == RegistrationOutcome::too_few_correspondences)
      NODELET_WARN_THROTTLE(5.0, "registration failed: %s (%zu)", toString(registration.outcome),
                            registration.correspondences);
  }

  /// Before the first broadcast, and now and then: afterwards TF has our own, and another's by
  /// chance. Once is enough.
  void checkBroadcast() {
    const std::string fault = topics_->broadcastFault(*placement_);
    if (fault.empty()) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (broadcast_fault_.empty()) NODELET_ERROR("%s", fault.c_str());
    broadcast_fault_ = fault;
  }

  void note(const OdometryStage::Result& result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (result.output.scan) numbers_.note(*result.output.scan);
    report_.noteTimes(scans_->description(), scans_->remedy());
  }

  // In any thread.

  void drop(const std::string& reason) {
    const std::lock_guard<std::mutex> lock(mutex_);
    stage_->countDropped(reason);
  }

  /// What callbacks have dropped: they must not wait until a scan is registered.
  void countUncounted() {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::size_t n = full_.exchange(0); n > 0; --n) stage_->countDropped("queue full");
    for (std::size_t n = damaged_.exchange(0); n > 0; --n)
      stage_->countDropped(describe(ScanRejection::bad_layout));
  }

  void onDamaged(const std::string& fault) {
    ++damaged_;
    NODELET_WARN_THROTTLE(5.0, "scan dropped: bad layout: %s", fault.c_str());
  }

  void onQueueFull() {
    ++full_;
    NODELET_WARN_THROTTLE(5.0, "the oldest scan that waits was dropped: %s",
                          placement_->fault().empty() ? "the odometry does not keep up"
                                                      : placement_->fault().c_str());
  }

  bool reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    reset_requested_ = true;
    response.success = true;
    response.message = "the odometry starts anew at the next scan";
    return true;
  }

  void diagnose(diagnostic_msgs::DiagnosticStatus& status) override {
    addValue("scans waiting", std::to_string(queue_->waiting()), status);
    report_.askMaster(*scans_);
    countUncounted();
    const std::lock_guard<std::mutex> lock(mutex_);
    report_.tell(*scans_, queue_->waiting(), placement_->fault(), numbers_.medianTime(), *stage_,
                 status);
    numbers_.tell(*stage_, status);
    if (broadcast_fault_.empty()) return;
    status.level = status.ERROR;
    status.message = broadcast_fault_;
  }

  /// What is held while no scan comes for a second has waited long enough for the next one.
  void flushWhereNoneComes() {
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (!lock) return;  // a scan is being registered
    const ros::WallTime now = ros::WallTime::now();
    const std::size_t arrived = scans_->arrived();
    if (std::exchange(arrived_before_, arrived) != arrived) arrived_at_ = now;
    if (stage_->held() > 0 && (now - arrived_at_).toSec() > 1.0) queue_->push(Flush{});
  }

  // Of the queue's thread.
  std::unique_ptr<ScanSubscription> scans_;
  std::unique_ptr<MotionSubscription> motions_;
  std::unique_ptr<SensorPlacement> placement_;
  std::unique_ptr<OdometryTopics> topics_;

  std::mutex mutex_;  // guards the next seven
  std::unique_ptr<OdometryStage> stage_;
  KnownMapPtr next_map_;  // that the next session goes on from
  InputReport report_;
  OdometryReport numbers_;
  std::size_t arrived_before_ = 0;
  ros::WallTime arrived_at_;
  std::string broadcast_fault_;

  std::atomic<bool> reset_requested_{false};
  std::atomic<std::size_t> full_{0}, damaged_{0};
  ros::ServiceServer reset_service_;
  ros::WallTimer flush_timer_;
  std::unique_ptr<MapLoader> loader_;
  std::unique_ptr<WorkQueue<Message>> queue_;
  std::unique_ptr<LiveParameters<LiveOdometryConfig, OdometryConfig>> live_parameters_;
};

}  // namespace revisit_slam

PLUGINLIB_EXPORT_CLASS(revisit_slam::OdometryNodelet, nodelet::Nodelet)
