// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/association/submap_association.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "revisit_slam/loops/association/view_overlap.h"

namespace revisit_slam {
namespace {

std::vector<Path> pathsOf(const std::vector<PlacedSubmap>& submaps) {
  std::vector<Path> paths;
  for (const PlacedSubmap& placed : submaps) paths.push_back(pathOf(placed));
  return paths;
}

std::vector<CoarseView> viewsOf(const std::vector<PlacedSubmap>& submaps, double scale) {
  std::vector<CoarseView> views;
  for (const PlacedSubmap& placed : submaps) views.emplace_back(placed.submap->points, scale);
  return views;
}

/// The largest distance of a scan from the keypose, m.
double sizeOf(const Submap& submap) {
  double size = 0.0;
  for (const Pose& T_submap_scan : submap.T_submap_scan)
    size = std::max(size, T_submap_scan.translation.norm());
  return size;
}

using IsBetter = bool (*)(const SubmapPair&, const SubmapPair&);

bool isNearer(const SubmapPair& a, const SubmapPair& b) {
  return a.hausdorff < b.hausdorff;
}

bool overlapsMore(const SubmapPair& a, const SubmapPair& b) {
  return a.overlap != b.overlap ? a.overlap > b.overlap : isNearer(a, b);
}

IsBetter choiceOf(const AssociationConfig& config) {
  return config.target == "nearest" ? isNearer : overlapsMore;
}

}  // namespace

double travelledBetween(const Submap& later, const Submap& earlier) {
  if (later.id.session != earlier.id.session) return std::numeric_limits<double>::infinity();
  return later.travelled_begin - earlier.travelled_end;
}

double largestGap(const Submap& later, const Submap& earlier, const AssociationConfig& config) {
  const double max_gap = std::max(later.scale, earlier.scale) * config.max_gap;
  if (config.min_detour <= 0.0) return max_gap;
  const double travelled = travelledBetween(later, earlier);
  if (travelled <= 0.0) return -1.0;  // next to each other, or the same
  const double size = std::max(sizeOf(later), sizeOf(earlier));
  return std::min(max_gap, (travelled + size) / config.min_detour - size);
}

std::vector<PlacedSubmap> placeByOdometry(const LocalMap& map, const Pose& T_common_local) {
  const Pose T_common_odom = T_common_local * map.T_odom_local().inverse();
  std::vector<PlacedSubmap> placed;
  for (const SubmapPtr& submap : map.submaps)
    placed.push_back({submap, T_common_odom * submap->T_odom_submap});
  return placed;
}

std::vector<PlacedSubmap> moved(std::vector<PlacedSubmap> submaps, const Pose& T_new_common) {
  for (PlacedSubmap& placed : submaps) {
    placed.T_common_submap = T_new_common * placed.T_common_submap;
    for (Pose& T_common_scan : placed.T_common_scan) T_common_scan = T_new_common * T_common_scan;
  }
  return submaps;
}

double scaleOf(const std::vector<PlacedSubmap>& a, const std::vector<PlacedSubmap>& b) {
  double scale = 0.0;
  for (const std::vector<PlacedSubmap>* submaps : {&a, &b})
    for (const PlacedSubmap& placed : *submaps) scale = std::max(scale, placed.submap->scale);
  return scale > 0.0 ? scale : 1.0;
}

Path pathOf(const PlacedSubmap& placed) {
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(placed.submap->T_submap_scan.size());
  for (const Pose& T_common_scan : placed.T_common_scan)
    positions.push_back(T_common_scan.translation);
  if (!positions.empty()) return Path(std::move(positions));
  const Eigen::Matrix3d R = placed.T_common_submap.rotationMatrix();
  for (const Pose& T_submap_scan : placed.submap->T_submap_scan)
    positions.push_back(R * T_submap_scan.translation + placed.T_common_submap.translation);
  return Path(std::move(positions));
}

std::vector<SubmapPair> associate(const std::vector<PlacedSubmap>& sources,
                                  const std::vector<PlacedSubmap>& targets,
                                  const AssociationConfig& config) {
  const std::vector<Path> source_paths = pathsOf(sources), target_paths = pathsOf(targets);
  const double scale = scaleOf(sources, targets);
  const std::vector<CoarseView> source_views = viewsOf(sources, scale),
                                target_views = viewsOf(targets, scale);
  const IsBetter isBetter = choiceOf(config);
  std::vector<SubmapPair> pairs;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    std::optional<SubmapPair> best;
    for (std::size_t r = 0; r < targets.size(); ++r) {
      const double gap = largestGap(*sources[k].submap, *targets[r].submap, config);
      if (gap < 0.0) continue;
      const double d = hausdorffDistance(source_paths[k], target_paths[r], config.max_hausdorff);
      if (d > config.max_hausdorff || !comeWithin(source_paths[k], target_paths[r], gap)) continue;
      const Pose guess = targets[r].T_common_submap.inverse() * sources[k].T_common_submap;
      const SubmapPair pair{k, r, d, CoarseView::overlap(source_views[k], target_views[r], guess)};
      if (pair.overlap < config.min_overlap) continue;
      if (!best || isBetter(pair, *best)) best = pair;
    }
    if (best) pairs.push_back(*best);
  }
  return pairs;
}

}  // namespace revisit_slam
