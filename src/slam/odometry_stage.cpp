// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/odometry_stage.h"

#include <exception>
#include <sstream>
#include <utility>

namespace revisit_slam {

namespace {

std::string describeVoxels(const RegisteredScan& scan) {
  std::ostringstream text;
  text << "the edge of the local map's voxels is now " << scan.voxel_size
       << " m, as far as scans reach";
  return text.str();
}

}  // namespace

OdometryStage::OdometryStage(const SlamConfig& config, SessionId first)
    : config_(config.odometry),
      rest_interval_(config.mapping.rest_interval),
      with_information_(config.information.enabled),
      session_(first),
      information_(config.information),
      arena_(config.odometry.threads),
      assembler_(config.input),
      gate_(config.odometry.max_prediction_time, config.odometry.restart_after),
      odometry_(config.odometry),
      rest_(config.mapping.rest_interval),
      voxel_size_(config.odometry.map.voxel_size) {}

std::vector<OdometryStage::Result> OdometryStage::process(ScanReading reading) {
  ++account_.received;
  account_.points_received += reading.counts.received;
  account_.points_dropped["not finite"] += reading.counts.not_finite;
  account_.points_dropped["at the sensor's origin"] += reading.counts.at_origin;
  account_.points_dropped["without time"] += reading.counts.no_time;
  if (!reading.scan) return {reject(describe(reading.rejection), reading.detail)};
  std::vector<Result> results;
  process(assembler_.take(std::move(reading)), results);
  return results;
}

std::vector<OdometryStage::Result> OdometryStage::flush() {
  std::vector<Result> results;
  process(assembler_.flush(), results);
  process(gate_.flush(), results);
  return results;
}

void OdometryStage::process(std::vector<SweepAssembler::Sweep> sweeps,
                            std::vector<Result>& results) {
  for (SweepAssembler::Sweep& sweep : sweeps) {
    account_.joined += sweep.messages - 1;
    if (sweep.refusal.empty()) {
      process(gate_.take(std::move(sweep.reading)), results);
    } else {
      results.push_back(reject(sweep.refusal));
    }
  }
  if (results.empty() || assembler_.description() == said_sweep_form_) return;
  said_sweep_form_ = assembler_.description();
  std::string& notice = results.front().notice;
  notice = notice.empty() ? said_sweep_form_ : said_sweep_form_ + "; " + notice;
}

void OdometryStage::process(std::vector<StampGate::Decision> decisions,
                            std::vector<Result>& results) {
  for (StampGate::Decision& decision : decisions) {
    if (!decision.refusal.empty()) {
      results.push_back(reject(decision.refusal));
      continue;
    }
    if (decision.went_back) beginSession();
    try {
      results.push_back(registerScan(std::move(decision.reading)));
    } catch (const std::exception& error) {  // those before it are registered, and go on
      results.push_back(reject("error", error.what()));
    }
    if (decision.went_back)
      results.back().notice = "the stamps went back by " + std::to_string(*decision.went_back) +
                              " s: a new session begins" +
                              (results.back().notice.empty() ? "" : "; " + results.back().notice);
  }
}

OdometryStage::Result OdometryStage::registerScan(ScanReading reading) {
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
  if (!aligned.scan) return reject(toString(aligned.outcome));
  ++account_.processed;
  if (aligned.scan->voxel_size != voxel_size_) result.notice = describeVoxels(*aligned.scan);
  voxel_size_ = aligned.scan->voxel_size;
  aligned.scan->id = idOf(*aligned.scan);
  aligned.scan->sensor_frame = std::move(reading.frame_id);
  result.output.scan = std::make_shared<const RegisteredScan>(std::move(*aligned.scan));
  return result;
}

ScanId OdometryStage::idOf(const RegisteredScan& scan) {
  if (rest_.repeats(scan.stamp, scan.T_odom_base))
    ++account_.at_rest;
  else
    ++ids_;
  return {ids_ - 1, session_};
}

std::shared_ptr<const RegistrationProblem> OdometryStage::gather(const RegisteredScan& scan) const {
  if (!with_information_ || odometry_.map().empty() || scan.verdict == PoseVerdict::lost)
    return nullptr;
  return std::make_shared<const RegistrationProblem>(
      information_.gather(scan.source_base, odometry_.map(), scan.T_odom_base,
                          Registration::maxCorrespondenceDistance(scan.sigma)));
}

void OdometryStage::countDropped(const std::string& reason) {
  ++account_.received;
  ++account_.dropped[reason];
  gate_.expectGap();
}

void OdometryStage::startSession() {
  beginSession();
  assembler_.restart();
  said_sweep_form_.clear();
  gate_.restart();
  account_ = {};
}

void OdometryStage::beginSession() {
  ++session_.value;
  odometry_ = Odometry(config_);
  rest_ = RestDetector(rest_interval_);
  ids_ = 0;
  voxel_size_ = config_.map.voxel_size;
}

void OdometryStage::reconfigure(const OdometryConfig& config) {
  config_ = config;
  odometry_.reconfigure(config);
}

OdometryStage::Result OdometryStage::reject(const std::string& reason, const std::string& detail) {
  ++account_.dropped[reason];
  Result result;
  result.rejection = detail.empty() ? reason : reason + ": " + detail;
  return result;
}

}  // namespace revisit_slam
