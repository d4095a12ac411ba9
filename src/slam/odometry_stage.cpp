// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/odometry_stage.h"

#include <utility>

namespace revisit_slam {

OdometryStage::OdometryStage(const SlamConfig& config, SessionId first)
    : config_(config.odometry),
      with_information_(config.information.enabled),
      session_(first),
      information_(config.information),
      arena_(config.odometry.threads),
      odometry_(config.odometry) {}

OdometryStage::Result OdometryStage::process(ScanReading reading) {
  ++account_.received;
  account_.points_received += reading.counts.received;
  account_.points_dropped["not finite"] += reading.counts.not_finite;
  account_.points_dropped["at the sensor's origin"] += reading.counts.at_origin;
  account_.points_dropped["without time"] += reading.counts.no_time;
  if (!reading.scan) return reject(describe(reading.rejection), reading.detail);

  Result result;
  OdometryResult aligned;
  arena_.execute([&] {
    aligned = odometry_.align(*reading.scan);
    StageClock clock;
    if (aligned.scan) result.output.problem = gather(*aligned.scan);
    clock.stage("gather");
    if (aligned.scan) odometry_.commit();
    clock.stage("update_map");
    result.times = std::move(aligned.times);
    for (const auto& time : clock.times()) result.times.push_back(time);
  });
  account_.points_dropped["too near"] += aligned.too_near;
  account_.points_dropped["too far"] += aligned.too_far;
  if (!aligned.scan) return reject(toString(aligned.outcome), "");
  ++account_.processed;
  aligned.scan->id.session = session_;
  aligned.scan->sensor_frame = std::move(reading.frame_id);
  result.output.scan = std::make_shared<const RegisteredScan>(std::move(*aligned.scan));
  return result;
}

std::shared_ptr<const RegistrationProblem> OdometryStage::gather(const RegisteredScan& scan) const {
  if (!with_information_ || odometry_.map().empty()) return nullptr;
  return std::make_shared<const RegistrationProblem>(
      information_.gather(scan.source_base, odometry_.map(), scan.T_odom_base,
                          Registration::maxCorrespondenceDistance(scan.sigma)));
}

void OdometryStage::countDropped(const std::string& reason) {
  ++account_.received;
  ++account_.dropped[reason];
}

void OdometryStage::startSession() {
  ++session_.value;
  odometry_ = Odometry(config_);
  account_ = {};
}

void OdometryStage::reconfigure(const OdometryConfig& config) {
  config_ = config;
  odometry_.reconfigure(config);
}

OdometryStage::Result OdometryStage::reject(const char* reason, const std::string& detail) {
  ++account_.dropped[reason];
  Result result;
  result.rejection = detail.empty() ? reason : std::string(reason) + ": " + detail;
  return result;
}

}  // namespace revisit_slam
