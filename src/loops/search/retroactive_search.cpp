// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/search/retroactive_search.h"

#include <algorithm>
#include <cstdlib>

namespace revisit_slam {
namespace {

Path optimisedPath(const LocalMap& map, const std::vector<Pose>& T_map_scan) {
  const std::size_t first = map.submaps.front()->first_scan.value;
  const std::size_t last = map.submaps.back()->lastScan().value;
  std::vector<Eigen::Vector3d> positions;
  for (std::size_t scan = first; scan <= last; ++scan)
    positions.push_back(T_map_scan[scan].translation);
  return Path(std::move(positions));
}

int distanceBetween(LocalMapId a, LocalMapId b) {
  return std::abs(static_cast<int>(a.value) - static_cast<int>(b.value));
}

int distanceBetween(const LocalMapPair& a, const LocalMapPair& b) {
  return std::max(distanceBetween(a.first, b.first), distanceBetween(a.second, b.second));
}

}  // namespace

std::vector<PlacedSubmap> placeByGraph(const LocalMap& map, const std::vector<Pose>& T_map_scan,
                                       const AssociationConfig& config) {
  std::vector<PlacedSubmap> placed;
  for (const SubmapPtr& submap : map.submaps) {
    const auto first = T_map_scan.begin() + submap->first_scan.value,
               last = T_map_scan.begin() + submap->lastScan().value;
    placed.push_back({submap, *first});
    if (config.usesOptimisedTrajectories()) placed.back().T_common_scan.assign(first, last + 1);
  }
  return placed;
}

std::vector<RetroactiveCandidate> RetroactiveSearch::search(
    const std::vector<LocalMapPtr>& maps, const std::vector<Pose>& T_map_scan,
    std::optional<LocalMapId> p, LocalMapId n, const std::set<LocalMapPair>& closed) const {
  std::vector<RetroactiveCandidate> candidates;
  if (!config_.enabled) return candidates;
  std::vector<Path> paths;
  for (std::size_t i = 0; i <= n.value; ++i) paths.push_back(optimisedPath(*maps[i], T_map_scan));
  const AssociationConfig& limits = config_.association;
  for (std::size_t i = p ? p->value + 1 : 0; i <= n.value; ++i)
    for (std::size_t j = 0; j < i + (config_.within_maps ? 1 : 0); ++j) {
      const LocalMapPair pair{maps[i]->id, maps[j]->id};
      if (closed.count(pair) > 0) continue;
      const double d = hausdorffDistance(paths[i], paths[j], limits.max_hausdorff);
      if (d <= limits.max_hausdorff && comeWithin(paths[i], paths[j], limits.max_gap) &&
          meetAgain(*maps[i], *maps[j], T_map_scan))
        candidates.push_back({pair, d, 0.0});
    }
  orderByGain(candidates, closed);
  return candidates;
}

std::vector<RetroactiveCandidate> RetroactiveSearch::searchLowDriftWindow(
    const std::vector<LocalMapPtr>& maps, const std::vector<Pose>& T_map_scan, LocalMapId n,
    const std::set<LocalMapPair>& closed) const {
  if (config_.low_drift_window <= 0.0) return {};
  std::optional<LocalMapId> before;
  if (n.value > 0) before = LocalMapId{n.value - 1, n.session};
  std::vector<RetroactiveCandidate> candidates = search(maps, T_map_scan, before, n, closed);
  const auto is_too_far_back = [&](const RetroactiveCandidate& candidate) {
    const LocalMap &later = *maps[candidate.maps.first.value],
                   &earlier = *maps[candidate.maps.second.value];
    return travelledBetween(*later.submaps.front(), *earlier.submaps.back()) >
           config_.low_drift_window;
  };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_too_far_back),
                   candidates.end());
  return candidates;
}

/// Whether any two submaps come near that are no neighbours.
bool RetroactiveSearch::meetAgain(const LocalMap& later, const LocalMap& earlier,
                                  const std::vector<Pose>& T_map_scan) const {
  const AssociationConfig& limits = config_.association;
  if (limits.min_detour <= 0.0) return true;
  std::vector<Path> paths;
  for (const PlacedSubmap& target : placeByGraph(earlier, T_map_scan, limits))
    paths.push_back(pathOf(target));
  for (const PlacedSubmap& source : placeByGraph(later, T_map_scan, limits)) {
    const Path path = pathOf(source);
    for (std::size_t r = 0; r < paths.size(); ++r) {
      const double gap = largestGap(*source.submap, *earlier.submaps[r], limits);
      if (gap >= 0.0 && comeWithin(path, paths[r], gap)) return true;
    }
  }
  return false;
}

/// Takes the best candidate, counts it as closed, and so on: what comes early spreads over the map.
void RetroactiveSearch::orderByGain(std::vector<RetroactiveCandidate>& candidates,
                                    const std::set<LocalMapPair>& closed) const {
  const auto closeness = [&](const RetroactiveCandidate& candidate) {
    return 1.0 - candidate.hausdorff / (config_.association.max_hausdorff + 1.0);
  };
  const auto lower = [&](RetroactiveCandidate& candidate, const LocalMapPair& known) {
    const double novelty = 1.0 * distanceBetween(known, candidate.maps) / config_.novelty_range;
    candidate.gain = std::min(candidate.gain, closeness(candidate) * novelty);
  };
  for (RetroactiveCandidate& candidate : candidates) {
    candidate.gain = closeness(candidate);
    for (const LocalMapPair& known : closed) lower(candidate, known);
  }
  const auto less = [](const auto& a, const auto& b) { return a.gain < b.gain; };
  for (auto next = candidates.begin(); next != candidates.end(); ++next) {
    std::iter_swap(next, std::max_element(next, candidates.end(), less));
    for (auto rest = next + 1; rest != candidates.end(); ++rest) lower(*rest, next->maps);
  }
}

}  // namespace revisit_slam
