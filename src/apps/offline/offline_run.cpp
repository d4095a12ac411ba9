// SPDX-License-Identifier: MIT
#include "offline_run.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "revisit_slam/util/process_usage.h"
#include "revisit_slam/ros/input/bag_scans.h"

namespace revisit_slam {

OfflineRun::OfflineRun(const SlamConfig& config, std::unique_ptr<ScanSource> source,
                       const std::string& folder, std::size_t max_scans, bool quiet)
    : config_(config),
      source_(std::move(source)),
      folder_(folder),
      front_end_(config),
      information_(config.information),
      files_(folder, config.mapping, config.occupancy),
      total_(max_scans > 0 ? std::min(max_scans, source_->size()) : source_->size()),
      progress_("mapping", "scans", total_, quiet),
      slam_(config, *this) {}

bool OfflineRun::run() {
  progress_.say(source_->description() + ", " + std::to_string(total_) + " scans");
  placeSensor();
  const bool all_read = processAll();
  finishMaps();
  progress_.finish();
  writeResults();
  return all_read;
}

void OfflineRun::placeSensor() {
  const std::string sensor_frame = source_->sensorFrame(), base_frame = config_.frames.base;
  tracked_frame_ = base_frame;
  if (base_frame.empty() || !source_->hasTransforms()) {
    tracked_frame_ = sensor_frame;
    progress_.say("poses are those of the sensor, frame '" + sensor_frame + "'" +
                  (base_frame.empty() ? "" : ": there are no transforms"));
    return;
  }
  const std::optional<Pose> T_base_sensor = source_->findExtrinsics(base_frame, sensor_frame);
  if (!T_base_sensor)
    throw BagError("the bag has no transform from '" + sensor_frame + "' to '" + base_frame +
                   "'; set frames/base to a frame that it has, or to nothing for the sensor's own");
  front_end_.setExtrinsics(*T_base_sensor);
}

bool OfflineRun::processAll() {
  std::size_t done = 0;
  double cpu_before_reading = threadCpuSeconds();
  const std::string damage = source_->forEach([&](const ScanMessage& message) {
    reading_cpu_seconds_ += threadCpuSeconds() - cpu_before_reading;
    if (done == total_) return false;
    process(message);
    progress_.update(++done);
    cpu_before_reading = threadCpuSeconds();
    return true;
  });
  if (!damage.empty()) progress_.say("after scan " + std::to_string(done) + ": " + damage);
  return damage.empty();
}

void OfflineRun::process(const ScanMessage& message) {
  FrontEnd::Result result = registerMessage(message);
  sayTimeSource();
  if (result.scan) {
    finishScan(std::move(*result.scan), std::move(result.times));
  } else {
    progress_.say("scan " + std::to_string(front_end_.account().received) +
                  " dropped: " + result.rejection);
  }
}

FrontEnd::Result OfflineRun::registerMessage(const ScanMessage& message) {
  if (const auto* unreadable = std::get_if<UnreadableScan>(&message)) {
    front_end_.countDropped("unreadable");
    FrontEnd::Result result;
    result.rejection = unreadable->reason;
    return result;
  }
  if (const auto* cloud = std::get_if<sensor_msgs::PointCloud2::ConstPtr>(&message))
    return front_end_.process(**cloud);
  return front_end_.process(*std::get<topic_tools::ShapeShifter::ConstPtr>(message));
}

void OfflineRun::finishScan(RegisteredScan&& scan, StageTimes times) {
  StageClock clock;
  const InformedScan informed =
      information_.inform(std::make_shared<const RegisteredScan>(std::move(scan)));
  clock.stage("information");
  if (config_.mapping.enabled) slam_.insert(informed);
  clock.stage("maps");
  for (const auto& time : clock.times()) times.push_back(time);
  folder_.add(informed, times);
}

void OfflineRun::finishMaps() {
  if (!config_.mapping.enabled) return;
  const Clock::time_point last_scan = Clock::now();
  slam_.finish();
  finish_seconds_ = std::chrono::duration<double>(Clock::now() - last_scan).count();
}

void OfflineRun::sayTimeSource() {
  if (front_end_.timeSource() == said_time_source_) return;
  said_time_source_ = front_end_.timeSource();
  progress_.say(said_time_source_);
}

void OfflineRun::onMaps(const MapUpdate& update) {
  files_.add(update);
  if (update.local_map) memory_.push_back({folder_.pathLength(), memoryMegabytes()});
}

void OfflineRun::onLoopSearch(const LoopSearchResult& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  background_times_.push_back(result.times);
  if (const std::size_t accepted = result.accepted().size())
    progress_.say("local map " + std::to_string(result.map->id.value) + " shows the place of " +
                  std::to_string(result.match->target.value) + ": " + std::to_string(accepted) +
                  " loop constraints");
}

void OfflineRun::onCorrection(const MapCorrectionPtr& correction) {
  const std::lock_guard<std::mutex> lock(mutex_);
  background_times_.push_back({{"optimisation", 1e3 * correction->seconds}});
}

void OfflineRun::writeResults() {
  const ScanAccount& account = front_end_.account();
  for (const StageTimes& times : background_times_) folder_.addTimes(times);
  RunSummary summary;
  summary.parameters = parametersOf(config_);
  summary.account = account;
  summary.topic = source_->description();
  summary.tracked_frame = tracked_frame_;
  summary.time_source = front_end_.timeSource();
  summary.wall_seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  summary.reading_cpu_seconds = reading_cpu_seconds_;
  summary.finish_seconds = finish_seconds_;
  summary.memory_mb_per_km = memoryPerKilometre();
  summary.threads = config_.odometry.threads;
  countLoops(summary);
  if (config_.mapping.enabled && account.processed > 0) {
    files_.write(slam_.backEnd());
    judgeConsistency(summary);
  }
  folder_.finish(summary);
  if (account.processed == 0)
    throw BagError("not one of " + std::to_string(account.received) +
                   " scans could be processed");
}

void OfflineRun::judgeConsistency(RunSummary& summary) {
  const MapConsistency consistency = files_.consistency(slam_.backEnd());
  summary.revisited_cells = consistency.cells.size();
  if (consistency.cells.empty()) return;
  summary.consistency_mean = consistency.mean;
  summary.consistency_deviation = consistency.standard_deviation;
  progress_.say("revisited places agree within " + std::to_string(consistency.mean) + " m RMS (" +
                std::to_string(consistency.cells.size()) + " cells)");
}

void OfflineRun::countLoops(RunSummary& summary) const {
  const BackEnd& back_end = slam_.backEnd();
  for (const LoopEdge& edge : back_end.graph().loops())
    ++summary.loops[std::string(toString(edge.loop.origin)) + " " + toString(edge.state)];
  summary.optimisations = back_end.count().optimisations;
  summary.rejected_optimisations = back_end.count().rejected_optimisations;
  summary.retroactive_pairs = back_end.count().retroactive_pairs;
}

/// Growth between the first and the last local map, where these are far enough from each other.
double OfflineRun::memoryPerKilometre() const {
  constexpr double kLeast = 200.0;
  if (memory_.empty()) return 0.0;
  const double metres = memory_.back().path_length - memory_.front().path_length;
  if (metres < kLeast) return 0.0;
  return 1000.0 * (memory_.back().megabytes - memory_.front().megabytes) / metres;
}

}  // namespace revisit_slam
