// SPDX-License-Identifier: MIT
#include "offline_run.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/slam/drop_remedies.h"
#include "revisit_slam/util/interruption.h"
#include "revisit_slam/util/process_usage.h"

namespace revisit_slam {
namespace {

constexpr const char* kReading = "read";  // the stage, which scans that waited have no time of

/// Where a drive is localized nothing is mapped.
SlamConfig withOrWithoutMaps(SlamConfig config) {
  config.mapping.enabled = config.mapping.enabled && config.localization.map.empty();
  return config;
}

/// How many of `size` scans are used.
std::size_t countOf(const OfflineExtent& extent, std::size_t size) {
  const std::size_t left = size - std::min(size, extent.first_scan);
  return extent.max_scans > 0 ? std::min(extent.max_scans, left) : left;
}

}  // namespace

OfflineRun::OfflineRun(const SlamConfig& config, std::unique_ptr<ScanSource> source,
                       const std::string& folder, OfflineExtent extent, bool quiet,
                       const KnownMapPtr& prior)
    : config_(withOrWithoutMaps(config)),
      source_(std::move(source)),
      folder_(folder),
      readers_(source_->sensors(), ScanReader(config.input)),
      motion_reader_(config.priors, config.gnss,
                     [this](const std::string& frame) -> std::optional<Pose> {
                       if (frame == tracked_frame_) return Pose::identity();
                       return source_->findExtrinsics(tracked_frame_, frame);
                     }),
      extent_(extent),
      first_session_(prior ? nextSession(prior->session.info) : SessionId{}),
      total_(countOf(extent, source_->size())),
      progress_(config_.mapping.enabled ? "mapping" : "localizing", "scans", total_, quiet),
      executor_(config.background),
      slam_(
          config_, *this, executor_, [this](SessionId session, Stamp) { return targetOf(session); },
          prior) {
  if (!config.localization.map.empty())
    localized_.emplace(config, folder_, [this](const std::string& text) { progress_.say(text); });
}

void OfflineRun::run() {
  progress_.say(source_->description() + ", " + std::to_string(total_) + " scans");
  if (!source_->notice().empty()) progress_.say(source_->notice() + " and left out");
  placeSensors();
  processAll();
  finishMaps();
  progress_.finish();
  sayPriors();
  sayLidars();
  const std::string drops = describeDrops(slam_.account());
  if (!drops.empty() && slam_.account().processed > 0) progress_.say("WARNING: " + drops);
  writeResults();
}

void OfflineRun::placeSensors() {
  const std::string sensor_frame = source_->sensorFrame(), base_frame = config_.frames.base;
  tracked_frame_ = base_frame;
  if (readers_.size() == 1 && (base_frame.empty() || !source_->hasTransforms())) {
    tracked_frame_ = sensor_frame;
    progress_.say("poses are those of the sensor, frame '" + sensor_frame + "'" +
                  (base_frame.empty() ? "" : ": there are no transforms"));
    return;
  }
  if (base_frame.empty()) tracked_frame_ = sensor_frame;
  for (std::size_t sensor = 0; sensor < readers_.size(); ++sensor) placeSensor(sensor);
}

void OfflineRun::placeSensor(std::size_t sensor) {
  const std::string frame = source_->sensorFrame(sensor);
  if (frame == tracked_frame_) return;
  const std::optional<Pose> T_base_sensor = source_->findExtrinsics(tracked_frame_, frame);
  if (!T_base_sensor)
    throw BagError("the bag has no transform from '" + frame + "' to '" + tracked_frame_ +
                   "'; give --base-frame a frame that it has, or none for the sensor's own");
  readers_[sensor].setExtrinsics(*T_base_sensor);
}

void OfflineRun::processAll() {
  std::size_t done = 0, passed = 0;
  double cpu_before_reading = threadCpuSeconds();
  source_->forEach([&](const ScanMessage& message) {
    reading_cpu_seconds_ += threadCpuSeconds() - cpu_before_reading;
    const bool is_motion = std::holds_alternative<MotionMessage>(message) ||
                           std::holds_alternative<UnreadableMotion>(message);
    if (interruption() != 0 || (!is_motion && done == total_)) return false;
    if (!is_motion && passed++ < extent_.first_scan) return true;
    process(message);
    if (!is_motion) progress_.update(++done);
    cpu_before_reading = threadCpuSeconds();
    return true;
  });
  if (interruption() != 0)
    progress_.say("interrupted after scan " + std::to_string(done) +
                  ": finishing its map; once more ends at once");
}

void OfflineRun::process(const ScanMessage& message) {
  StageClock clock;
  if (const auto* unreadable = std::get_if<UnreadableScan>(&message)) {
    slam_.countDropped("unreadable");
    onRejection(unreadable->reason);
  } else if (const auto* motion = std::get_if<MotionMessage>(&message)) {
    process(*motion);
  } else if (const auto* unreadable_motion = std::get_if<UnreadableMotion>(&message)) {
    slam_.countDroppedMotion(unreadable_motion->sensor, unreadable_motion->reason);
  } else if (const auto* cloud = std::get_if<PointCloud>(&message)) {
    insert(readers_.front().read(*cloud), 0, clock);
  } else {
    const auto& raw = std::get<RawMessage>(message);
    insert(readers_[raw.sensor].read(raw), raw.sensor, clock);
  }
}

void OfflineRun::process(const MotionMessage& message) {
  const std::optional<MotionReader::Result> result = motion_reader_.read(message);
  if (!result) return;
  if (!result->reading) return slam_.countDroppedMotion(result->sensor, result->rejection);
  slam_.insert(*result->reading);
}

void OfflineRun::sayPriors() {
  for (const auto& [sensor, account] : slam_.sensorAccounts()) {
    std::string line = sensor + ": " + std::to_string(account.received) + " messages; entered " +
                       std::to_string(account.used) + " scans, rejected in " +
                       std::to_string(account.rejected) + ", missing in " +
                       std::to_string(account.missing);
    if (account.scale) line += "; scale " + std::to_string(*account.scale);
    if (const auto& bias = account.bias)
      line += "; bias " + std::to_string(bias->x()) + " " + std::to_string(bias->y()) + " " +
              std::to_string(bias->z()) + " rad/s";
    for (const auto& [reason, count] : account.dropped)
      line += "; dropped " + std::to_string(count) + ": " + reason;
    progress_.say(line);
  }
}

void OfflineRun::sayLidars() {
  for (const auto& [topic, account] : slam_.lidarAccounts()) {
    std::string line = topic + ": " + std::to_string(account.messages) + " messages, " +
                       std::to_string(account.points) + " points in sweeps";
    for (const auto& [reason, count] : account.points_dropped)
      line += "; dropped " + std::to_string(count) + ": " + reason;
    progress_.say(line);
  }
}

void OfflineRun::insert(ScanReading reading, std::size_t sensor, StageClock clock) {
  clock.stage(kReading);
  reading.sensor = sensor;
  sayTimeSource();
  slam_.insert(std::move(reading), clock.times());
}

void OfflineRun::onScan(const InformedScan& informed, const StageTimes& times) {
  const std::string notice = verdicts_.take(informed);
  if (!notice.empty())
    progress_.say("scan " + std::to_string(slam_.account().received) + ": " + notice);
  StageTimes all_times = times;
  const bool was_read_before = times.empty() || times.front().first != std::string(kReading);
  if (was_read_before) all_times.insert(all_times.begin(), {kReading, 0.0});
  if (localized_) {
    StageClock clock;
    localized_->add(informed);
    clock.stage("localization");
    for (const auto& time : clock.times()) all_times.push_back(time);
  }
  folder_.log().add(entryOf(informed, all_times));
}

void OfflineRun::onRejection(const std::string& reason) {
  progress_.say("scan " + std::to_string(slam_.account().received) + " dropped: " + reason);
}

void OfflineRun::finishMaps() {
  const Clock::time_point last_scan = Clock::now();
  slam_.finish();
  finish_seconds_ = std::chrono::duration<double>(Clock::now() - last_scan).count();
}

void OfflineRun::sayTimeSource() {
  const ScanReader& reader = toBeTold(readers_);
  if (reader.description() == said_time_source_) return;
  said_time_source_ = reader.description();
  const std::string remedy = reader.remedy();
  progress_.say(remedy.empty() ? said_time_source_
                               : "WARNING: " + said_time_source_ + "; " + remedy);
}

/// The first session is in the folder itself, others in folders within.
SessionTarget OfflineRun::targetOf(SessionId session) const {
  if (session == first_session_)
    return {folder_.path(), source_->description(), folder_.lock(), true};
  const std::uint32_t number = session.value - first_session_.value + 1;
  return {folder_.file("session_" + std::to_string(number)), source_->description(), nullptr,
          false};
}

void OfflineRun::onMaps(const MapUpdate& update) {
  if (update.local_map) memory_.push_back({folder_.log().pathLength(), memoryMegabytes()});
}

/// What waits to be written is no reason to stop, but to make room. In the background, whose
/// session it is.
void OfflineRun::sayWhatWaits() {
  const std::string problem = slam_.session() != nullptr ? slam_.session()->problem() : "";
  if (problem == said_problem_) return;
  said_problem_ = problem;
  progress_.say(problem.empty() ? "everything is on disk again"
                                : "not on disk, and tried again: " + problem);
}

void OfflineRun::onLoopSearch(const LoopSearchResult& result) {
  sayWhatWaits();
  for (const LoopProposal& proposal : result.proposals) folder_.log().add(candidateOf(proposal));
  const std::lock_guard<std::mutex> lock(mutex_);
  background_times_.push_back(result.times);
  if (result.origin == LoopOrigin::retroactive) {
    retroactive_pairs_ += static_cast<int>(result.proposals.size());
    return;
  }
  if (const std::size_t accepted = result.accepted().size())
    progress_.say("local map " + std::to_string(result.map->id.value) + " shows the place of " +
                  std::to_string(result.match->target.value) + ": " + std::to_string(accepted) +
                  " loop constraints");
}

void OfflineRun::onCorrection(const MapCorrectionPtr& correction) {
  const std::lock_guard<std::mutex> lock(mutex_);
  background_times_.push_back({{"optimisation", 1e3 * correction->seconds}});
}

/// The last one is written when everything is known of the run.
void OfflineRun::onSession(GraphSession& session) {
  if (&session != slam_.session()) exportMaps(session);
}

/// Whether the drive has found its way into the map that it goes on from.
void OfflineRun::sayWhetherJoined(const GraphSession& session) {
  if (first_session_ == SessionId{} || session.id() != first_session_) return;
  progress_.say(
      session.isPlaced()
          ? "the drive is in the map that it extends"
          : "the drive was not found in the map that it should extend: no loop ties them");
}

void OfflineRun::exportMaps(GraphSession& session) {
  sayWhetherJoined(session);
  for (const std::string& notice : session.saveOwn()) progress_.say(notice);
}

void OfflineRun::writeResults() {
  const ScanAccount& account = slam_.account();
  for (const StageTimes& times : background_times_) folder_.log().addTimes(times);
  RunSummary summary;
  summary.parameters = parametersOf(config_);
  summary.input = {account, slam_.sensorAccounts(), slam_.lidarAccounts(),
                   readers_.front().description()};
  summary.interrupted = interruption() != 0;
  summary.topic = source_->description();
  summary.tracked_frame = tracked_frame_;
  summary.wall_seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  summary.reading_cpu_seconds = reading_cpu_seconds_;
  summary.finish_seconds = finish_seconds_;
  summary.memory_mb_per_km = memoryPerKilometre();
  summary.threads = config_.odometry.threads;
  summary.retroactive_pairs = retroactive_pairs_;
  if (slam_.session() != nullptr) slam_.session()->tell(summary);
  if (config_.mapping.enabled && account.processed > 0) {
    exportMaps(*slam_.session());
    judgeConsistency(summary);
  }
  if (localized_) localized_->finish();
  folder_.finish(summary);
  if (account.processed == 0)
    throw BagError(account.received == 0
                       ? "there was no scan in " + source_->description()
                       : "not one of " + std::to_string(account.received) +
                             " scans could be processed: " + describeDrops(account));
}

void OfflineRun::judgeConsistency(RunSummary& summary) {
  judge(consistencyOf(slam_.session()->snapshot()), summary);
  if (summary.revisited_cells > 0)
    progress_.say("revisited places agree within " + std::to_string(summary.consistency_mean) +
                  " m RMS (" + std::to_string(summary.revisited_cells) + " cells)");
}

/// Growth between the first and the last local map, where these are far enough from each other.
std::optional<double> OfflineRun::memoryPerKilometre() const {
  constexpr double kLeast = 200.0;
  if (memory_.empty()) return std::nullopt;
  const double metres = memory_.back().path_length - memory_.front().path_length;
  if (metres < kLeast) return std::nullopt;
  return 1000.0 * (memory_.back().megabytes - memory_.front().megabytes) / metres;
}

}  // namespace revisit_slam
