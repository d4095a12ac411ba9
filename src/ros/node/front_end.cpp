// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/front_end.h"

#include <sensor_msgs/PointCloud2.h>
#include <topic_tools/shape_shifter.h>

namespace revisit_slam {
namespace {

Odometry::BeforeInsertion gatherWith(const InformationConfig& config,
                                     const InformationEstimator& estimator) {
  if (!config.enabled) return {};
  return [&estimator](RegisteredScan& scan, const LocalVoxelMap& map) {
    scan.problem = estimator.gather(scan.source_base, map, scan.T_odom_base,
                                    Registration::maxCorrespondenceDistance(scan.sigma));
  };
}

}  // namespace

FrontEnd::FrontEnd(const SlamConfig& config)
    : reader_(config.input),
      information_(config.information),
      odometry_(config.odometry, gatherWith(config.information, information_)) {}

template <typename Message>
FrontEnd::Result FrontEnd::process(const Message& message) {
  StageClock clock;
  ScanReading reading = reader_.read(message);
  clock.stage("read");
  return registerReading(std::move(reading), std::move(clock));
}

template FrontEnd::Result FrontEnd::process(const sensor_msgs::PointCloud2&);
template FrontEnd::Result FrontEnd::process(const topic_tools::ShapeShifter&);

FrontEnd::Result FrontEnd::registerReading(ScanReading reading, StageClock clock) {
  ++account_.received;
  account_.points_received += reading.counts.received;
  account_.points_dropped["not finite"] += reading.counts.not_finite;
  account_.points_dropped["at the sensor's origin"] += reading.counts.at_origin;
  account_.points_dropped["without time"] += reading.counts.no_time;
  if (!reading.scan) return reject(describe(reading.rejection), reading.detail);

  OdometryResult odometry = odometry_.registerScan(*reading.scan);
  account_.points_dropped["too near"] += odometry.too_near;
  account_.points_dropped["too far"] += odometry.too_far;
  if (!odometry.scan) return reject(toString(odometry.outcome), "");
  ++account_.processed;
  odometry.scan->sensor_frame = reading.frame_id;
  Result result{std::move(odometry.scan), "", clock.times()};
  result.times.insert(result.times.end(), odometry.times.begin(), odometry.times.end());
  return result;
}

void FrontEnd::countDropped(const std::string& reason) {
  ++account_.received;
  ++account_.dropped[reason];
}

FrontEnd::Result FrontEnd::reject(const char* reason, const std::string& detail) {
  ++account_.dropped[reason];
  Result result;
  result.rejection = detail.empty() ? reason : std::string(reason) + ": " + detail;
  return result;
}

}  // namespace revisit_slam
