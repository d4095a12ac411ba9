// SPDX-License-Identifier: MIT
#include <revisit_slam/LiveInformationConfig.h>
#include <ros/master.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <map>
#include <pluginlib/class_list_macros.hpp>

#include "revisit_slam/util/work_queue.h"
#include "revisit_slam/information/motion_covariance.h"
#include "revisit_slam/slam/information_stage.h"
#include "revisit_slam/ros/node/in_process_topic.h"
#include "revisit_slam/ros/node/live_parameters.h"
#include "revisit_slam/ros/node/patient_publisher.h"
#include "revisit_slam/ros/messages/scan_messages.h"
#include "slam_nodelet.h"

namespace revisit_slam {

/// Gives every registered scan the information of its edge, on a thread of its own, and publishes
/// the odometry with its covariance. No scan is left out: when scans pile up the information of the
/// scan before is repeated, marked and counted.
class InformationNodelet : public SlamNodelet {
 public:
  InformationNodelet() : SlamNodelet("information") {}
  ~InformationNodelet() override {
    stopDiagnostics();
    subscriber_.shutdown();
    live_parameters_.reset();
    if (queue_) queue_->stop();
  }

 private:
  using RegisteredScanPtr = boost::shared_ptr<const RegisteredScan>;

  void start() override {
    ros::NodeHandle& node = getNodeHandle();
    stage_ = std::make_unique<InformationStage>(config_.information);

    informed_publisher_ = {node.advertise<InformedScan>("informed_scan", 100),
                           [this] { return mapsAndGraphAreThere(); }};
    odometry_publisher_ = node.advertise<nav_msgs::Odometry>("odometry", 100);
    markers_publisher_ = node.advertise<visualization_msgs::MarkerArray>("weak_directions", 2);
    live_parameters_ = std::make_unique<LiveParameters<LiveInformationConfig, InformationConfig>>(
        getPrivateNodeHandle(), "information", config_.information,
        [this](const InformationConfig& config) { reconfigure(config); });

    // Scans are light pointers here, and none may be lost.
    queue_ = std::make_unique<WorkQueue<RegisteredScanPtr>>(
        std::numeric_limits<std::size_t>::max(),
        [this](const RegisteredScanPtr& scan) { handle(scan); }, [] {});
    subscriber_ = node.subscribe<RegisteredScan>(
        "registered_scan", 0, [this](const RegisteredScanPtr& scan) { queue_->push(scan); });
  }

  /// They advertise these when they listen to scans. The number of subscribers does not tell: those
  /// of one process count as one.
  bool mapsAndGraphAreThere() const {
    if (!config_.mapping.enabled) return true;
    ros::master::V_TopicInfo topics;
    ros::master::getTopics(topics);
    const auto advertised = [&](const char* name) {
      const std::string wanted = getNodeHandle().resolveName(name);
      return std::any_of(topics.begin(), topics.end(),
                         [&](const auto& topic) { return topic.name == wanted; });
    };
    return advertised("submap") && advertised("map_correction");
  }

  // In the thread of the queue.

  void handle(const RegisteredScanPtr& scan) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (scan->id == ScanId{0}) startAnew();
    const bool behind =
        queue_->waiting() > static_cast<std::size_t>(config_.information.max_waiting);
    const auto informed = boost::make_shared<const InformedScan>(
        behind ? stage_->repeat(toStdPointer(scan)) : stage_->inform(toStdPointer(scan)));
    if (behind)
      NODELET_WARN_THROTTLE(5.0, "information falls behind: that of an earlier scan is repeated");
    ++scans_by_source_[informed->source];
    weak_directions_ = informed->estimate.weak_directions;
    publish(*informed);
    informed_publisher_.publish(informed);
  }

  void startAnew() {
    stage_ = std::make_unique<InformationStage>(config_.information);
    pose_covariance_ = PoseCovariance();
    previous_.reset();
  }

  void publish(const InformedScan& informed) {
    const RegisteredScan& scan = *informed.scan;
    nav_msgs::Odometry odometry = toOdometry(scan, config_.frames.odom, baseFrame(scan));
    if (previous_) {
      pose_covariance_.move(previous_->T_odom_base.inverse() * scan.T_odom_base,
                            informed.covariance_motion);
      fillCovariances(pose_covariance_.base(), informed.covariance_motion,
                      secondsBetween(previous_->stamp, scan.stamp), scan.T_odom_base, odometry);
    }
    previous_ = informed.scan;
    odometry_publisher_.publish(odometry);
    if (markers_publisher_.getNumSubscribers() > 0)
      markers_publisher_.publish(
          toMarkers(informed.estimate.weak_directions, scan.stamp, baseFrame(scan)));
  }

  const std::string& baseFrame(const RegisteredScan& scan) const {
    return config_.frames.base.empty() ? scan.sensor_frame : config_.frames.base;
  }

  // In the threads of the node.

  void reconfigure(const InformationConfig& config) {
    const std::lock_guard<std::mutex> lock(mutex_);
    config_.information = config;
    stage_->reconfigure(config);
  }

  void diagnose(diagnostic_msgs::DiagnosticStatus& status) override {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const std::size_t repeated = scans_by_source_[InformationSource::repeated];
      const bool newly_repeated = repeated > reported_repeats_;
      reported_repeats_ = repeated;
      const bool weak = !weak_directions_.empty();
      status.level = weak || newly_repeated ? status.WARN : status.OK;
      status.message = newly_repeated ? "falling behind" : weak ? "weak directions" : "running";
      for (const auto& [source, count] : scans_by_source_)
        addValue(std::string("scans ") + toString(source), std::to_string(count), status);
      for (const WeakDirection& direction : weak_directions_)
        addValue("weak direction, eigenvalue " + std::to_string(direction.eigenvalue),
                 toText(direction.direction), status);
    }
    addValue("scans waiting", std::to_string(queue_->waiting()), status);
  }

  static std::string toText(const Tangent& direction) {
    const Eigen::IOFormat on_one_line(3, Eigen::DontAlignCols, " ", " ");
    std::ostringstream text;
    text << direction.transpose().format(on_one_line);
    return text.str();
  }

  PatientPublisher<InformedScan> informed_publisher_;
  ros::Publisher odometry_publisher_, markers_publisher_;

  std::mutex mutex_;  // guards the next six
  std::unique_ptr<InformationStage> stage_;
  PoseCovariance pose_covariance_;
  std::shared_ptr<const RegisteredScan> previous_;
  std::map<InformationSource, std::size_t> scans_by_source_;
  std::vector<WeakDirection> weak_directions_;
  std::size_t reported_repeats_ = 0;

  std::unique_ptr<WorkQueue<RegisteredScanPtr>> queue_;
  ros::Subscriber subscriber_;
  std::unique_ptr<LiveParameters<LiveInformationConfig, InformationConfig>> live_parameters_;
};

}  // namespace revisit_slam

PLUGINLIB_EXPORT_CLASS(revisit_slam::InformationNodelet, nodelet::Nodelet)
