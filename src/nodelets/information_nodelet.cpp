// SPDX-License-Identifier: MIT
#include <revisit_slam/LiveInformationConfig.h>

#include <boost/make_shared.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "revisit_slam/ros/messages/scan_messages.h"
#include "revisit_slam/ros/node/live_parameters.h"
#include "revisit_slam/ros/node/patient_publisher.h"
#include "revisit_slam/ros/node/slam_nodelet.h"
#include "revisit_slam/ros/node/stage_topics.h"
#include "revisit_slam/ros/node/verdict_report.h"
#include "revisit_slam/slam/information_stage.h"

namespace revisit_slam {

/// Hosts the information stage, and publishes the odometry with its covariance.
class InformationNodelet : public SlamNodelet {
 public:
  InformationNodelet() : SlamNodelet("information") {}
  ~InformationNodelet() override {
    stopDiagnostics();
    subscriber_.shutdown();
    live_parameters_.reset();
    if (lane_) lane_->stop();
  }

 private:
  void start() override {
    ros::NodeHandle& node = getNodeHandle();
    stage_ = std::make_unique<InformationStage>(config_.information);
    const bool with_maps = config_.mapping.enabled;
    informed_publisher_ = {node.advertise<InformedScan>("informed_scan", 100), [node, with_maps] {
                             return !with_maps || areAdvertised(node, {"submap", "map_correction"});
                           }};
    odometry_publisher_ = node.advertise<nav_msgs::Odometry>("odometry", 100);
    verdicts_ = std::make_unique<VerdictReport>(node);
    markers_publisher_ = node.advertise<visualization_msgs::MarkerArray>("weak_directions", 2);
    lane_ = makeLane("information", 0);
    live_parameters_ = std::make_unique<LiveParameters<LiveInformationConfig, InformationConfig>>(
        getPrivateNodeHandle(), "information", config_.information,
        [this](const InformationConfig& config) {
          lane_->post([this, config] { stage_->reconfigure(config); });
        });
    const uint32_t depth = 0;  // no limit: none may be lost
    subscriber_ = node.subscribe<OdometryOutput>(
        "registered_scan", depth, [this](const boost::shared_ptr<const OdometryOutput>& odometry) {
          lane_->post([this, odometry] { handle(*odometry); });
        });
  }

  /// Whatever happens: a scan that is missing would end the graph.
  InformedScan inform(const OdometryOutput& odometry) {
    try {
      return stage_->inform(odometry, lane_->waiting());
    } catch (const std::exception& error) {
      noteError(error.what());
      return stage_->inform(odometry, std::numeric_limits<std::size_t>::max());
    }
  }

  void handle(const OdometryOutput& odometry) {
    const auto informed = boost::make_shared<const InformedScan>(inform(odometry));
    if (informed->source == InformationSource::repeated)
      NODELET_WARN_THROTTLE(5.0, "information falls behind: that of an earlier scan is repeated");
    verdicts_->take(*informed);
    publish(*informed);
    informed_publisher_.publish(informed);
  }

  void publish(const InformedScan& informed) {
    const RegisteredScan& scan = *informed.scan;
    const std::string& base_frame =
        config_.frames.base.empty() ? scan.sensor_frame : config_.frames.base;
    odometry_publisher_.publish(toOdometry(informed, ownOdomFrame(config_), base_frame));
    if (markers_publisher_.getNumSubscribers() > 0)
      markers_publisher_.publish(
          toMarkers(informed.estimate.weak_directions, scan.stamp, base_frame));
  }

  void diagnose(diagnostic_msgs::DiagnosticStatus& status) override {
    addValue("scans waiting", std::to_string(lane_->waiting()), status);
    verdicts_->diagnose(status);
  }

  std::unique_ptr<InformationStage> stage_;  // of the lane
  std::unique_ptr<VerdictReport> verdicts_;
  PatientPublisher<InformedScan> informed_publisher_;
  ros::Publisher odometry_publisher_, markers_publisher_;

  std::unique_ptr<ThreadLane> lane_;
  ros::Subscriber subscriber_;
  std::unique_ptr<LiveParameters<LiveInformationConfig, InformationConfig>> live_parameters_;
};

}  // namespace revisit_slam

PLUGINLIB_EXPORT_CLASS(revisit_slam::InformationNodelet, nodelet::Nodelet)
