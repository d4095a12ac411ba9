// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/place_search.h"

#include <utility>

namespace revisit_slam {
namespace {

/// Streets meet in local maps: the right one is often the second best.
constexpr std::size_t kMost = 3;

}  // namespace

PlaceSearch::PlaceSearch(PriorMapPtr map, const PlaceRecognitionConfig& config)
    : map_(std::move(map)), config_(config), recognition_(config) {
  // By their places in the list: ids may have gaps.
  for (std::size_t i = 0; i < map_->places.size(); ++i)
    recognition_.add(LocalMapId{static_cast<std::uint32_t>(i), map_->info.id},
                     map_->places[i].T_level_local, map_->places[i].features);
}

std::vector<Pose> PlaceSearch::search(const LocalMap& local) const {
  std::vector<Pose> found;
  for (const PlaceMatch& match : recognition_.find(viewPlace(local, config_))) {
    if (match.inliers <= config_.min_inliers || found.size() == kMost) break;
    found.push_back(map_->T_map_place[match.target.value] * match.T_target_source);
  }
  return found;
}

}  // namespace revisit_slam
