// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/map_manager.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "revisit_slam/session/known_map.h"
#include "revisit_slam/slam/thinned_scan.h"

namespace revisit_slam {

MapManager::MapManager(const SlamConfig& config, Lane& building, Lane& searching, Outputs outputs)
    : mapping_(config.mapping),
      occupancy_(config.occupancy),
      scale_{config.mapping.follow_scale, config.odometry.map.voxel_size},
      building_(building),
      searching_(searching),
      outputs_(std::move(outputs)),
      arena_(config.background.threads),
      config_(config) {}

void MapManager::insert(const InformedScan& informed) {
  const bool is_behind = building_.waiting() > static_cast<std::size_t>(mapping_.max_waiting);
  if (is_behind) ++count_.thinned_scans;
  building_.post([this, kept = is_behind ? withoutPoints(*informed.scan) : informed.scan,
                  unsure = unsureOf(informed)] { build(*kept, unsure); });
}

/// Roll and pitch that are hardly held lift what lies ahead, and a heading that is hardly held
/// moves it in the plane. A scan that fits badly holds nothing for certain.
MapManager::Unsure MapManager::unsureOf(const InformedScan& informed) {
  Unsure unsure;
  if (informed.verdict >= PoseVerdict::poor) {
    unsure.weak = unsure.weak_height = 1.0;
    unsure.doubt = std::sqrt(informed.covariance_motion.topLeftCorner<3, 3>().trace());
  }
  for (const WeakDirection& weak : informed.estimate.weak_directions) {
    const auto translation = weak.direction.head<3>(), rotation = weak.direction.tail<3>();
    unsure.weak = std::max({unsure.weak, translation.head<2>().norm(), std::abs(rotation.z())});
    unsure.weak_height =
        std::max({unsure.weak_height, std::abs(translation.z()), rotation.head<2>().norm()});
  }
  return unsure;
}

void MapManager::build(const RegisteredScan& scan, const Unsure& unsure) {
  const std::uint32_t scans_before = order_.scans();
  switch (order_.take(scan.id)) {
    case ScanOrder::repeated:
      return;
    case ScanOrder::missed:
      ++count_.missed_scans;
      return;
    case ScanOrder::first:
      if (builder_) closeSession(0, scans_before);
      session_ = scan.id.session;
      unsure_ = {};
      position_odom_ = scan.T_odom_base.translation;
      builder_ = std::make_unique<MapBuilder>(mapping_, occupancy_);
      library_ = std::make_shared<SubmapLibrary>(mapping_.cacheBytes());
      if (scan.goes_on_from) library_->addStored(scan.goes_on_from->library);
      searching_.post([this, session = session_, prior = scan.goes_on_from, library = library_] {
        begin(session, prior, library);
      });
      break;
    case ScanOrder::next:
      break;
  }
  hand(builder_->insert(scan, startWith(scan, unsure)));
}

/// What a submap takes over that begins with this scan.
SubmapStart MapManager::startWith(const RegisteredScan& scan, const Unsure& unsure) {
  SubmapStart start;
  start.size = scale_.sizeOf(scan.voxel_size);
  start.scale = scale_.scaleOf(scan.voxel_size);
  const double step = (scan.T_odom_base.translation - position_odom_).norm();
  position_odom_ = scan.T_odom_base.translation;
  unsure_.weak += unsure.weak * step;
  unsure_.weak_height += unsure.weak_height * step;
  unsure_.doubt += unsure.doubt;
  start.unsure = unsure_;
  start.after_loss = scan.verdict == PoseVerdict::lost;
  start.sensor_base = scan.sensor_base;
  return start;
}

void MapManager::close(std::uint32_t request) {
  building_.post([this, request] { closeSession(request, order_.scans()); });
}

void MapManager::closeSession(std::uint32_t request, std::uint32_t scans) {
  if (builder_) hand(builder_->closeAll());
  const MapsClosed closed{session_, scans, request};
  inLane(session_, [closed](LoopClosing& closing) { closing.finish(closed); });
}

void MapManager::hand(MapUpdate update) {
  if (!update.submap) return;
  library_->add(update.submap, update.occupancy);
  update.library = library_;
  const auto maps = std::make_shared<const MapUpdate>(std::move(update));
  outputs_.maps(maps);
  if (!maps->local_map) return;
  ++handed_;
  ++count_.maps_waiting;
  inLane(session_, [this, map = maps->local_map](LoopClosing& closing) {
    --handed_;
    closing.add(map);
  });
}

void MapManager::correct(const MapCorrectionPtr& correction) {
  inLane(correction->session, [correction](LoopClosing& closing) { closing.correct(correction); });
}

void MapManager::reconfigure(const std::function<void(LoopsConfig&, RetroactiveConfig&)>& change) {
  searching_.post([this, change] {
    change(config_.loops, config_.retroactive);
    for (auto& [session, closing] : closing_)
      closing.reconfigure(config_.loops, config_.retroactive);
  });
}

void MapManager::giveUpWaiting() {
  searching_.post([this] {
    for (auto& [session, closing] : closing_)
      arena_.execute([&, &closing = closing] { closing.giveUpWaiting(); });
    tidyUp();
  });
}

void MapManager::begin(SessionId session, const KnownMapPtr& prior,
                       const std::shared_ptr<SubmapLibrary>& library) {
  newest_ = session;
  LoopClosing& closing =
      closing_.try_emplace(session, config_, outputs_.loops, library).first->second;
  if (prior) arena_.execute([&] { closing.goOnFrom({prior.get()}); });
  outputs_.session(session, prior);
}

void MapManager::inLane(SessionId session, const std::function<void(LoopClosing&)>& work) {
  searching_.post([this, session, work] {
    LoopClosing& closing = closing_.try_emplace(session, config_, outputs_.loops).first->second;
    arena_.execute([&] { work(closing); });
    tidyUp();
  });
}

/// A session that is over lives on until its work is done.
void MapManager::tidyUp() {
  std::size_t waiting = static_cast<std::size_t>(handed_);
  for (auto entry = closing_.begin(); entry != closing_.end();) {
    waiting += entry->second.waiting();
    const bool is_over = entry->first != newest_ && entry->second.isIdle();
    entry = is_over ? closing_.erase(entry) : std::next(entry);
  }
  count_.maps_waiting = static_cast<int>(waiting);
}

}  // namespace revisit_slam
