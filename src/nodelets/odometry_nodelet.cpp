// SPDX-License-Identifier: MIT
#include <revisit_slam/LiveOdometryConfig.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>
#include <topic_tools/shape_shifter.h>

#include <boost/make_shared.hpp>
#include <pluginlib/class_list_macros.hpp>
#include <variant>

#include "revisit_slam/util/recent_times.h"
#include "revisit_slam/util/work_queue.h"
#include "revisit_slam/ros/node/front_end.h"
#include "revisit_slam/ros/node/in_process_topic.h"
#include "revisit_slam/ros/node/live_parameters.h"
#include "revisit_slam/ros/node/patient_publisher.h"
#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/ros/messages/scan_messages.h"
#include "slam_nodelet.h"

namespace revisit_slam {

/// Convert, register, broadcast. Scans wait in a queue of their own, so that the number that the
/// odometry could not take is known.
class OdometryNodelet : public SlamNodelet {
 public:
  OdometryNodelet() : SlamNodelet("odometry") {}
  ~OdometryNodelet() override {
    stopDiagnostics();
    points_subscriber_.shutdown();
    livox_subscriber_.shutdown();
    reset_service_.shutdown();
    live_parameters_.reset();
    if (queue_) queue_->stop();  // not reset(): its thread looks at queue_ until it ends
  }

 private:
  using CloudPtr = sensor_msgs::PointCloud2::ConstPtr;
  using LivoxPtr = topic_tools::ShapeShifter::ConstPtr;
  using Message = std::variant<CloudPtr, LivoxPtr>;

  void start() override {
    ros::NodeHandle& node = getNodeHandle();
    ros::NodeHandle& private_node = getPrivateNodeHandle();
    startSession();

    const ros::Publisher registered = node.advertise<RegisteredScan>("registered_scan", 100);
    registered_publisher_ = {registered,
                             [registered] { return registered.getNumSubscribers() > 0; }};
    odometry_publisher_ = node.advertise<nav_msgs::Odometry>("odometry_raw", 100);
    cloud_publisher_ = node.advertise<sensor_msgs::PointCloud2>("deskewed_points", 2);
    reset_service_ = private_node.advertiseService("reset", &OdometryNodelet::reset, this);
    live_parameters_ = std::make_unique<LiveParameters<LiveOdometryConfig, OdometryConfig>>(
        private_node, "odometry", config_.odometry,
        [this](const OdometryConfig& config) { reconfigure(config); });

    queue_ = std::make_unique<WorkQueue<Message>>(
        config_.live.queue_size, [this](const Message& message) { handle(message); },
        [this] { onQueueFull(); });
    const uint32_t depth = 0;  // no limit: only the queue above drops scans, as it counts them
    points_subscriber_ = node.subscribe<sensor_msgs::PointCloud2>(
        "points", depth, [this](const CloudPtr& cloud) { queue_->push(cloud); });
    livox_subscriber_ = node.subscribe<topic_tools::ShapeShifter>(
        "livox_points", depth, [this](const LivoxPtr& message) { queue_->push(message); });
  }

  void startSession() {
    front_end_ = std::make_unique<FrontEnd>(config_);
    session_ = static_cast<std::int64_t>(ros::WallTime::now().toNSec());
    scan_times_ = {};
  }

  // In the thread of the queue.

  void handle(const Message& message) {
    std::visit([this](const auto& pointer) { registerMessage(*pointer); }, message);
  }

  template <typename T>
  void registerMessage(const T& message) {
    if (!extrinsics_known_ && !waitForExtrinsics(frameOf(message))) return;
    StageClock clock;
    FrontEnd::Result result;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      result = front_end_->process(message);
      if (result.scan) result.scan->session = session_;
    }
    sayTimeSource();
    if (!result.scan) {
      NODELET_WARN_THROTTLE(5.0, "scan dropped: %s", result.rejection.c_str());
      return;
    }
    publish(std::move(*result.scan));
    clock.stage("scan");
    const std::lock_guard<std::mutex> lock(mutex_);
    scan_times_.add(clock.times().back().second);
  }

  static std::string frameOf(const sensor_msgs::PointCloud2& cloud) {
    return cloud.header.frame_id;
  }

  static std::string frameOf(const topic_tools::ShapeShifter& message) {
    std::vector<uint8_t> bytes(message.size());
    ros::serialization::OStream out(bytes.data(), message.size());
    message.write(out);
    ros::serialization::IStream in(bytes.data(), message.size());
    std_msgs::Header header;
    ros::serialization::deserialize(in, header);
    return header.frame_id;
  }

  /// Later scans wait in the queue meanwhile. Polls by wall clock: simulated time may not run.
  bool waitForExtrinsics(const std::string& sensor_frame) {
    base_frame_ = config_.frames.base.empty() ? sensor_frame : config_.frames.base;
    while (!queue_->stopping()) {
      try {
        const auto transform = tf_buffer_.lookupTransform(base_frame_, sensor_frame, ros::Time(0));
        const std::lock_guard<std::mutex> lock(mutex_);
        front_end_->setExtrinsics(toPose(transform.transform));
        return extrinsics_known_ = true;
      } catch (const tf2::TransformException&) {
        NODELET_WARN_THROTTLE(5.0, "waiting for the transform from '%s' to '%s'; scans wait too",
                              sensor_frame.c_str(), base_frame_.c_str());
        ros::WallDuration(0.05).sleep();
      }
    }
    return false;
  }

  void publish(RegisteredScan&& registered) {
    const auto scan = boost::make_shared<const RegisteredScan>(std::move(registered));
    const std::string& odom_frame = config_.frames.odom;
    tf_broadcaster_.sendTransform(toTransform(*scan, odom_frame, base_frame_));
    odometry_publisher_.publish(toOdometry(*scan, odom_frame, base_frame_));
    registered_publisher_.publish(scan);
    if (cloud_publisher_.getNumSubscribers() > 0)
      cloud_publisher_.publish(boost::make_shared<sensor_msgs::PointCloud2>(
          toPointCloud(scan->points_base, scan->stamp, base_frame_)));
    const RegistrationResult& registration = scan->registration;
    if (registration.outcome == RegistrationOutcome::too_few_correspondences)
      NODELET_WARN_THROTTLE(5.0, "registration failed: %s (%zu)", toString(registration.outcome),
                            registration.correspondences);
    const std::lock_guard<std::mutex> lock(mutex_);
    last_registration_ = registration;
    last_delay_ = secondsBetween(scan->stamp, toStamp(ros::Time::now()));
  }

  void sayTimeSource() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (front_end_->timeSource() == said_time_source_) return;
    said_time_source_ = front_end_->timeSource();
    NODELET_INFO("%s", said_time_source_.c_str());
  }

  // In the threads of the node.

  void onQueueFull() {
    const std::lock_guard<std::mutex> lock(mutex_);
    front_end_->countDropped("queue full");
    NODELET_WARN_THROTTLE(5.0,
                          "the odometry does not keep up: the oldest waiting scan was dropped");
  }

  bool reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    const std::lock_guard<std::mutex> lock(mutex_);
    startSession();
    extrinsics_known_ = false;
    response.success = true;
    response.message = "the odometry starts anew at the next scan";
    return true;
  }

  void reconfigure(const OdometryConfig& config) {
    const std::lock_guard<std::mutex> lock(mutex_);
    config_.odometry = config;
    front_end_->reconfigure(config);
  }

  void diagnose(diagnostic_msgs::DiagnosticStatus& status) override {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const ScanAccount& account = front_end_->account();
      const std::size_t dropped = account.droppedInAll();
      const bool newly_dropped = dropped > reported_drops_;
      reported_drops_ = dropped;
      status.level = newly_dropped ? status.WARN : status.OK;
      status.message = account.received == 0 ? "no scan yet"
                       : newly_dropped       ? "scans were dropped"
                                             : "running";
      addValue("point times", front_end_->timeSource(), status);
      addValue("registration", toString(last_registration_.outcome), status);
      addValue("iterations", std::to_string(last_registration_.iterations), status);
      addValue("delay (s)", std::to_string(last_delay_), status);
      addValue("time of a scan: median, p99, largest (ms)", scan_times_.summary(), status);
      addAccount(account, status);
    }
    addValue("scans waiting", std::to_string(queue_->waiting()), status);
  }

  std::string base_frame_;  // that of the poses; the queue's thread alone uses it
  tf2_ros::Buffer tf_buffer_;
  tf2_ros::TransformListener tf_listener_{tf_buffer_};
  tf2_ros::TransformBroadcaster tf_broadcaster_;
  PatientPublisher<RegisteredScan> registered_publisher_;
  ros::Publisher odometry_publisher_, cloud_publisher_;
  ros::ServiceServer reset_service_;

  std::mutex mutex_;  // guards the next seven
  std::unique_ptr<FrontEnd> front_end_;
  std::int64_t session_ = 0;
  std::string said_time_source_;
  RegistrationResult last_registration_;
  double last_delay_ = 0.0;  // s
  RecentTimes scan_times_;
  std::size_t reported_drops_ = 0;

  std::atomic<bool> extrinsics_known_{false};
  std::unique_ptr<WorkQueue<Message>> queue_;
  ros::Subscriber points_subscriber_, livox_subscriber_;
  std::unique_ptr<LiveParameters<LiveOdometryConfig, OdometryConfig>> live_parameters_;
};

}  // namespace revisit_slam

PLUGINLIB_EXPORT_CLASS(revisit_slam::OdometryNodelet, nodelet::Nodelet)
