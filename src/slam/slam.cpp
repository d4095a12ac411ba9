// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/slam.h"

#include "revisit_slam/util/niceness.h"

namespace revisit_slam {
namespace {

/// Scans that may wait for the background; light, as only their graph nodes wait.
constexpr std::size_t kMostWaiting = 200;

}  // namespace

Slam::Slam(const SlamConfig& config, SlamObserver& observer)
    : observer_(observer),
      background_(config.background),
      builder_(config.mapping, config.occupancy),
      loops_(config.loops, config.information),
      back_end_(config,
                [this](const MapCorrectionPtr& correction) { observer_.onCorrection(correction); }),
      arena_(config.background.threads),
      queue_(kMostWaiting, [this](const Work& item) { work(item); }, [] {}) {}

Slam::~Slam() { queue_.stop(); }

void Slam::insert(const InformedScan& informed) {
  hand(builder_.insert(*informed.scan));
  queue_.pushWaiting(nodeOf(informed));
}

void Slam::finish() {
  hand(builder_.closeAll());
  queue_.pushWaiting(Finish{});
  queue_.drain();
  if (error_) std::rethrow_exception(error_);
}

void Slam::hand(const MapUpdate& update) {
  if (update.submap) observer_.onMaps(update);
  if (update.local_map) queue_.pushWaiting(update.local_map);
}

void Slam::work(const Work& item) {
  if (error_) return;
  if (!nice_) setThreadNiceness(background_.niceness);
  nice_ = true;
  try {
    arena_.execute([&] { std::visit([this](const auto& what) { handle(what); }, item); });
  } catch (...) {
    error_ = std::current_exception();
  }
}

void Slam::handle(const LocalMapPtr& map) {
  const LoopSearchResult result = loops_.search(map);
  observer_.onLoopSearch(result);
  back_end_.add(map, result.accepted());
}

}  // namespace revisit_slam
