// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/slam.h"

#include <stdexcept>
#include <utility>

namespace revisit_slam {
namespace {

/// Local maps that may wait for their search: they hold their points until then. A search and the
/// graph answer each other behind the nodes that wait in the background, so that scans which come
/// faster than from a sensor would leave them farther and farther behind.
constexpr int kMostMapsWaiting = 2;

}  // namespace

Slam::Slam(const SlamConfig& config, SlamObserver& observer, Executor& executor,
           SessionTargets targets, const KnownMapPtr& prior)
    : observer_(observer),
      executor_(executor),
      with_maps_(config.mapping.enabled),
      odometry_(config, {}, prior),
      information_(config.information),
      back_end_(
          config,
          [this](const MapCorrectionPtr& correction) {
            if (correction->version > 0) observer_.onCorrection(correction);
            maps_.correct(correction);
          },
          std::move(targets)),
      maps_(config, foreground_, executor.background(), outputsOfMaps()) {}

/// What waits in the background speaks to the stages. After finish() there is nothing.
Slam::~Slam() {
  executor_.background().discard();
  executor_.background().drain();
}

MapManager::Outputs Slam::outputsOfMaps() {
  MapManager::Outputs outputs;
  outputs.maps = [this](const MapUpdatePtr& maps) {
    observer_.onMaps(*maps);
    executor_.background().post([this, maps] { back_end_.add(maps); });
  };
  outputs.session = [](SessionId, const KnownMapPtr&) {};
  outputs.loops.search = [this](const LoopSearchResult& result) { observer_.onLoopSearch(result); };
  outputs.loops.closures = [this](const LoopClosures& closures) {
    executor_.background().post([this, closures] { back_end_.add(closures); });
  };
  outputs.loops.closed = [this](const MapsClosed& closed) {
    executor_.background().post([this, closed] { end(closed); });
  };
  outputs.loops.problem = [this](const std::string& problem) {
    executor_.background().post([problem] { throw std::runtime_error(problem); });
  };
  return outputs;
}

void Slam::insert(ScanReading reading, const StageTimes& times) {
  for (const OdometryStage::Result& result : odometry_.process(std::move(reading)))
    take(result, times);
}

void Slam::insert(const MotionReading& reading) {
  for (const OdometryStage::Result& result : odometry_.takeMotion(reading)) take(result, {});
}

void Slam::take(const OdometryStage::Result& result, StageTimes times) {
  if (!result.notice.empty()) observer_.onNotice(result.notice);
  if (!result.output.scan) return observer_.onRejection(result.rejection);
  const InformedScan informed = information_.inform(result.output);
  times.insert(times.end(), informed.times.begin(), informed.times.end());
  StageClock clock;
  insert(informed);
  clock.stage("maps");
  for (const auto& time : clock.times()) times.push_back(time);
  observer_.onScan(informed, times);
}

void Slam::insert(const InformedScan& informed) {
  if (!with_maps_) return;
  has_scans_ = true;
  // First the node: the maps of the session before may end with this scan.
  executor_.background().post([this, node = nodeOf(informed), prior = informed.scan->goes_on_from] {
    back_end_.add(node, prior);
  });
  maps_.insert(informed);
  if (maps_.count().maps_waiting > kMostMapsWaiting) executor_.background().drain();
}

void Slam::end(const MapsClosed& closed) {
  back_end_.add(closed, [this](GraphSession* session, const std::string& problem) {
    if (!problem.empty()) throw std::runtime_error(problem);
    observer_.onSession(*session);
  });
}

void Slam::finish() {
  for (const OdometryStage::Result& result : odometry_.flush()) take(result, {});
  if (has_scans_) maps_.close(0);
  executor_.finish();
}

}  // namespace revisit_slam
