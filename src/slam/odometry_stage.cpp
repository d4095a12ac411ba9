// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/odometry_stage.h"

#include <algorithm>
#include <exception>
#include <sstream>
#include <utility>

#include "revisit_slam/odometry/fused_motion_predictor.h"

namespace revisit_slam {

namespace {

std::string describeVoxels(const RegisteredScan& scan) {
  std::ostringstream text;
  text << "the edge of the local map's voxels is now " << scan.voxel_size
       << " m, as far as scans reach";
  return text.str();
}

/// m. No robot is as large: what is farther from its base is placed in another frame.
constexpr double kLongestLever = 100.0;

std::string describeLever(const ScanReading& reading) {
  std::ostringstream text;
  text << "frame '" << reading.frame_id << "' is " << reading.scan->T_base_sensor.translation.norm()
       << " m from the base frame; its transform has to be that of the sensor on the robot";
  return text.str();
}

void putFirst(const std::string& text, std::string& notice) {
  notice = notice.empty() ? text : text + "; " + notice;
}

}  // namespace

OdometryStage::OdometryStage(const SlamConfig& config, SessionId first, KnownMapPtr prior)
    : config_(config.odometry),
      priors_config_(config.priors),
      rest_interval_(config.mapping.rest_interval),
      with_information_(config.information.enabled),
      session_(prior ? nextSession(prior->session.info) : first),
      prior_(std::move(prior)),
      information_(config.information),
      arena_(config.odometry.threads),
      assembler_(config.input),
      merger_(config.input),
      gate_(config.odometry.max_prediction_time, config.odometry.restart_after),
      priors_(config.priors),
      gnss_(config.gnss),
      gravity_(config.gravity),
      odometry_(makeOdometry()),
      rest_(config.mapping.rest_interval),
      voxel_size_(config.odometry.map.voxel_size) {}

Odometry OdometryStage::makeOdometry() {
  auto predictor = std::make_unique<ConstantVelocityPredictor>(config_);
  if (!priors_.isConnected()) return Odometry(config_, std::move(predictor));
  return Odometry(config_, std::make_unique<FusedMotionPredictor>(config_, std::move(predictor),
                                                                  priors_config_, priors_));
}

std::vector<OdometryStage::Result> OdometryStage::process(ScanReading reading) {
  const bool is_misplaced =
      reading.scan && reading.scan->T_base_sensor.translation.norm() > kLongestLever;
  const bool is_merged = merger_.merges() && reading.scan && !is_misplaced;
  if (!is_merged) ++account_.received;  // of several sensors the sweeps count
  std::vector<Result> results;
  try {
    take(std::move(reading), is_merged, is_misplaced, results);
  } catch (const std::exception& error) {  // no memory: it has not come as far as registerNext
    if (is_merged) ++account_.received;
    results.push_back(reject("error", error.what()));
  }
  return results;
}

void OdometryStage::take(ScanReading reading, bool is_merged, bool is_misplaced,
                         std::vector<Result>& results) {
  account_.points_received += reading.counts.received;
  account_.points_dropped["not finite"] += reading.counts.not_finite;
  account_.points_dropped["at the sensor's origin"] += reading.counts.at_origin;
  account_.points_dropped["without time"] += reading.counts.no_time;
  if (!reading.scan)
    results.push_back(reject(describe(reading.rejection), reading.detail));
  else if (is_misplaced)
    results.push_back(reject("wrong transform", describeLever(reading)));
  else if (is_merged)
    process(merger_.take(std::move(reading)), results);
  else
    process(assembler_.take(std::move(reading)), results);
}

std::vector<OdometryStage::Result> OdometryStage::takeMotion(const MotionReading& reading) {
  std::vector<Result> results;
  if (const auto* position = std::get_if<GnssReading>(&reading)) {
    gnss_.take(*position);
    return results;
  }
  if (const auto* imu = std::get_if<ImuReading>(&reading)) gravity_.take(*imu);
  priors_.take(reading);
  release(false, results);
  return results;
}

std::vector<OdometryStage::Result> OdometryStage::flush() {
  std::vector<Result> results;
  process(assembler_.flush(), results);
  process(merger_.flush(), results);
  process(gate_.flush(), results);
  release(true, results);
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
  putFirst(said_sweep_form_, results.front().notice);
}

void OdometryStage::process(std::vector<ScanReading> merged, std::vector<Result>& results) {
  for (ScanReading& reading : merged) {
    ++account_.received;
    process(gate_.take(std::move(reading)), results);
  }
}

void OdometryStage::process(std::vector<StampGate::Decision> decisions,
                            std::vector<Result>& results) {
  for (StampGate::Decision& decision : decisions) {
    if (decision.refusal.empty()) {
      waiting_.push_back(std::move(decision));
      release(false, results);
    } else {
      results.push_back(reject(decision.refusal));
    }
  }
}

void OdometryStage::release(bool all, std::vector<Result>& results) {
  while (!waiting_.empty() && mayGoOn(all)) registerNext(results);
}

/// Whether the first scan that waits has all measured motion that it may expect.
bool OdometryStage::mayGoOn(bool all) {
  const Stamp stamp = waiting_.front().reading.scan->stamp;
  if (priors_.reach(stamp)) return true;
  const StampGate::Decision& last = waiting_.back();
  const bool of_another_clock = last.reading.scan->stamp < stamp;
  const double ahead = secondsBetween(stamp, last.reading.scan->stamp);
  if (!all && !of_another_clock && ahead < priors_config_.max_wait) return false;
  if (!all && !of_another_clock) silence_ = priors_.giveUp(stamp);
  return true;
}

void OdometryStage::registerNext(std::vector<Result>& results) {
  StampGate::Decision decision = std::move(waiting_.front());
  waiting_.pop_front();
  if (decision.went_back) beginSession();
  Result result;
  try {
    results.reserve(results.size() + 1);
    result = registerScan(std::move(decision.reading));
  } catch (const std::exception& error) {  // those before it are registered, and go on
    result = reject("error", error.what());
  }
  if (!silence_.empty())
    putFirst(
        "no messages of " + std::exchange(silence_, "") + ": scans do not wait for them any longer",
        result.notice);
  if (decision.went_back)
    putFirst("the stamps went back by " + std::to_string(*decision.went_back) +
                 " s: a new session begins",
             result.notice);
  results.push_back(std::move(result));
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
    result.output.times = std::move(aligned.times);
    for (const auto& time : clock.times()) result.output.times.push_back(time);
  });
  account_.points_dropped["too near"] += aligned.too_near;
  account_.points_dropped["too far"] += aligned.too_far;
  if (aligned.on_body > 0) account_.points_dropped["on the body"] += aligned.on_body;
  if (!aligned.scan) return reject(toString(aligned.outcome));
  aligned.scan->sensor_frame = std::move(reading.frame_id);
  if (aligned.scan->voxel_size != voxel_size_) result.notice = describeVoxels(*aligned.scan);
  voxel_size_ = aligned.scan->voxel_size;
  const std::string tilt = tilt_check_.take(*aligned.scan);
  if (!tilt.empty()) putFirst(tilt, result.notice);
  const auto scan = std::make_shared<RegisteredScan>(std::move(*aligned.scan));
  const bool is_at_rest = nameScan(*scan);
  // Nothing from here on can fail: the numbers of scans have no gaps.
  scan->goes_on_from = std::exchange(prior_, nullptr);
  ++account_.processed;
  account_.at_rest += is_at_rest ? 1 : 0;
  ids_ += is_at_rest ? 0 : 1;
  result.output.scan = scan;
  return result;
}

/// Scans at rest have the number of the last one that counts, and add nothing to the graph: what is
/// due goes with the next that does. Where a base was carried meanwhile, it does not rest where it
/// is held to be. @return whether this one is at rest.
bool OdometryStage::nameScan(RegisteredScan& scan) {
  if (scan.verdict == PoseVerdict::lost) rest_ = RestDetector(rest_interval_);
  const bool is_repeated = rest_.repeats(scan.stamp, scan.T_odom_base);
  scan.id = {is_repeated ? ids_ - 1 : ids_, session_};
  gnss_.observe(scan.id, scan.stamp, scan.T_odom_base);
  if (const auto direction = gravity_.observe(scan.id, scan.stamp, scan.T_odom_base))
    direction_due_ = direction;
  if (is_repeated) return true;
  scan.fixes = gnss_.due();
  scan.gravity = std::exchange(direction_due_, std::nullopt);
  return false;
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

void OdometryStage::countDroppedMotion(const std::string& sensor, const std::string& reason) {
  if (sensor == GnssTrack::kSensor)
    gnss_.countDropped(reason);
  else
    priors_.countDropped(sensor, reason);
}

std::map<std::string, PriorAccount> OdometryStage::sensorAccounts() const {
  std::map<std::string, PriorAccount> accounts = priors_.accounts();
  if (gnss_.isConnected()) accounts[GnssTrack::kSensor] = gnss_.account();
  if (gravity_.account().received > 0) accounts[GravityTrack::kSensor] = gravity_.account();
  return accounts;
}

void OdometryStage::startSession(KnownMapPtr prior) {
  waiting_.clear();
  beginSession();
  prior_ = std::move(prior);
  if (prior_) session_ = std::max(session_, nextSession(prior_->session.info));
  assembler_.restart();
  merger_.restart();
  said_sweep_form_.clear();
  gate_.restart();
  account_ = {};
}

void OdometryStage::beginSession() {
  ++session_.value;
  prior_.reset();
  priors_.restart();
  gnss_.restart();
  gravity_.restart();
  direction_due_.reset();
  odometry_ = makeOdometry();
  rest_ = RestDetector(rest_interval_);
  tilt_check_ = {};
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
