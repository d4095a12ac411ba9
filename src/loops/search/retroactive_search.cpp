// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/search/retroactive_search.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace revisit_slam {
namespace {

Path optimisedPath(const LocalMap& map, const ScanPoses& T_map_scan) {
  const ScanId last = map.submaps.back()->lastScan();
  std::vector<Eigen::Vector3d> positions;
  for (ScanId scan = map.submaps.front()->first_scan; scan.value <= last.value; ++scan.value)
    positions.push_back(T_map_scan[scan].translation);
  return Path(std::move(positions));
}

SessionOffsets<LocalMapId> orderOf(const std::vector<LocalMapPtr>& maps) {
  SessionOffsets<LocalMapId> order;
  for (const LocalMapPtr& map : maps) order.append(map->id);
  return order;
}

/// In local maps along the drive; no two sessions are near.
int distanceBetween(LocalMapId a, LocalMapId b) {
  if (a.session != b.session) return std::numeric_limits<int>::max();
  return std::abs(static_cast<int>(a.value) - static_cast<int>(b.value));
}

int distanceBetween(const LocalMapPair& a, const LocalMapPair& b) {
  return std::max(distanceBetween(a.first, b.first), distanceBetween(a.second, b.second));
}

}  // namespace

std::vector<PlacedSubmap> placeByGraph(const LocalMap& map, const ScanPoses& T_map_scan,
                                       const AssociationConfig& config) {
  std::vector<PlacedSubmap> placed;
  for (const SubmapPtr& submap : map.submaps) {
    placed.push_back({submap, T_map_scan[submap->first_scan]});
    if (config.usesOptimisedTrajectories())
      placed.back().T_common_scan =
          T_map_scan.from(submap->first_scan, submap->T_submap_scan.size());
  }
  return placed;
}

std::vector<RetroactiveCandidate> RetroactiveSearch::search(
    const std::vector<LocalMapPtr>& maps, const ScanPoses& T_map_scan, std::optional<LocalMapId> p,
    LocalMapId n, const std::set<LocalMapPair>& closed) const {
  std::vector<RetroactiveCandidate> candidates;
  if (!config_.enabled) return candidates;
  const SessionOffsets<LocalMapId> order = orderOf(maps);
  std::vector<Path> paths;
  for (std::size_t i = 0; i <= order[n]; ++i) paths.push_back(optimisedPath(*maps[i], T_map_scan));
  const AssociationConfig& limits = config_.association;
  for (std::size_t i = p ? order[*p] + 1 : 0; i <= order[n]; ++i)
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
    const std::vector<LocalMapPtr>& maps, const ScanPoses& T_map_scan, LocalMapId n,
    const std::set<LocalMapPair>& closed) const {
  if (config_.low_drift_window <= 0.0) return {};
  const SessionOffsets<LocalMapId> order = orderOf(maps);
  std::optional<LocalMapId> before;
  if (order[n] > 0) before = maps[order[n] - 1]->id;
  std::vector<RetroactiveCandidate> candidates = search(maps, T_map_scan, before, n, closed);
  const auto is_too_far_back = [&](const RetroactiveCandidate& candidate) {
    const LocalMap &later = *maps[order[candidate.maps.first]],
                   &earlier = *maps[order[candidate.maps.second]];
    return travelledBetween(*later.submaps.front(), *earlier.submaps.back()) >
           config_.low_drift_window;
  };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_too_far_back),
                   candidates.end());
  return candidates;
}

/// Whether any two submaps come near that are no neighbours.
bool RetroactiveSearch::meetAgain(const LocalMap& later, const LocalMap& earlier,
                                  const ScanPoses& T_map_scan) const {
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
