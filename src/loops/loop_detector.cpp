// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/loop_detector.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace revisit_slam {
namespace {

RetroactiveConfig searchConfig(const LoopsConfig& loops, RetroactiveConfig retroactive) {
  retroactive.enabled = retroactive.enabled && loops.enabled;
  return retroactive;
}

/// Associates submaps by the limits by which the search finds local maps.
LoopCloserConfig closerConfig(const LoopsConfig& loops, const RetroactiveConfig& retroactive) {
  LoopCloserConfig closer = loops.closer;
  closer.association = retroactive.association;
  return closer;
}

}  // namespace

LoopDetector::LoopDetector(const LoopsConfig& loops, const RetroactiveConfig& retroactive,
                           const InformationConfig& information)
    : enabled_(loops.enabled),
      drift_(loops.closer.drift),
      max_pairs_(retroactive.max_pairs),
      search_at_end_(retroactive.search_at_end),
      recognition_(loops.recognition),
      appearance_closer_(loops.closer, information),
      retroactive_closer_(closerConfig(loops, retroactive), information),
      retroactive_(searchConfig(loops, retroactive)) {}

void LoopDetector::reconfigure(const LoopsConfig& loops, const RetroactiveConfig& retroactive) {
  drift_ = loops.closer.drift;
  max_pairs_ = retroactive.max_pairs;
  recognition_.reconfigure(loops.recognition);
  appearance_closer_.reconfigure(loops.closer);
  retroactive_closer_.reconfigure(closerConfig(loops, retroactive));
  retroactive_.reconfigure(searchConfig(loops, retroactive));
}

LoopSearchResult LoopDetector::newSearch(LoopOrigin origin) const {
  LoopSearchResult result;
  result.origin = origin;
  result.map = maps_.back();
  return result;
}

LoopSearchResult LoopDetector::searchByAppearance(const LocalMapPtr& map) {
  maps_.push_back(map);
  LoopSearchResult result = newSearch(LoopOrigin::appearance);
  if (!enabled_) return result;
  StageClock clock;
  result.match = recognition_.recognise(*map);
  result.candidates = recognition_.candidates();
  result.view = std::make_shared<const PlaceView>(recognition_.lastView());
  clock.stage("recognition");
  if (result.match) {
    result.proposals = closeByAppearance(*map, *result.match);
    for (LoopProposal& proposal : result.proposals) proposal.loop.inliers = result.match->inliers;
  }
  clock.stage("registration");
  result.times = clock.times();
  return result;
}

/// The place that was recognised says where the local maps are to each other; within them submaps
/// are where the odometry or the graph has them.
std::vector<LoopProposal> LoopDetector::closeByAppearance(const LocalMap& source,
                                                          const PlaceMatch& match) const {
  const LocalMap& target = *maps_.at(match.target.value);
  const AssociationConfig& association = appearance_closer_.association();
  const std::vector<Pose> T_map_scan = placeScans();
  const PriorOf priors = priorsOf(T_map_scan);
  if (!association.usesOptimisedTrajectories())
    return appearance_closer_.close(source, target, match.T_target_source, LoopOrigin::appearance,
                                    priors);
  const auto placed = [&](const LocalMap& map, const Pose& T_common_local) {
    const Pose& T_map_local = T_map_scan[map.submaps.front()->first_scan.value];
    return moved(placeByGraph(map, T_map_scan, association),
                 T_common_local * T_map_local.inverse());
  };
  return appearance_closer_.close(placed(source, match.T_target_source),
                                  placed(target, Pose::identity()), LoopOrigin::appearance, priors);
}

/// Where the graph has the submaps, and how far it may be off.
PriorOf LoopDetector::priorsOf(const std::vector<Pose>& T_map_scan) const {
  std::vector<SubmapPtr> submaps;
  for (const LocalMapPtr& map : maps_)
    submaps.insert(submaps.end(), map->submaps.begin(), map->submaps.end());
  const auto drift = std::make_shared<const GraphDrift>(
      std::move(submaps), correction_ ? correction_->loops : std::vector<LoopEdge>{}, drift_);
  return [drift, &T_map_scan](const Submap& source, const Submap& target) {
    return LoopPrior{
        T_map_scan[target.first_scan.value].inverse() * T_map_scan[source.first_scan.value],
        drift->from(source.id)[target.id.value]};
  };
}

LoopSearchResult LoopDetector::searchRetroactively() {
  LoopSearchResult result = newSearch(LoopOrigin::retroactive);
  if (searchWindow(tried_, result)) {
    searched_ = maps_.back()->id;
    tried_.clear();
  }
  return result;
}

LoopSearchResult LoopDetector::searchUnspent(std::set<LocalMapPair>& tried) {
  LoopSearchResult result = newSearch(LoopOrigin::retroactive);
  if (search_at_end_) searchWindow(tried, result);
  return result;
}

/// As many pairs as may be at a time. @return whether these were all.
bool LoopDetector::searchWindow(std::set<LocalMapPair>& tried, LoopSearchResult& result) const {
  StageClock clock;
  const std::vector<Pose> T_map_scan = placeScans();
  std::vector<RetroactiveCandidate> candidates =
      retroactive_.search(maps_, T_map_scan, searched_, maps_.back()->id, closed_);
  const auto was_tried = [&](const auto& candidate) { return tried.count(candidate.maps) > 0; };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), was_tried),
                   candidates.end());
  const std::size_t done = close(candidates, T_map_scan, result);
  for (std::size_t i = 0; i < done; ++i) tried.insert(candidates[i].maps);
  clock.stage("retroactive");
  result.times = clock.times();
  return done == candidates.size();
}

/// What is not closed now may be once the graph has moved it: it does not count as tried.
LoopSearchResult LoopDetector::searchLowDriftWindow() {
  LoopSearchResult result = newSearch(LoopOrigin::retroactive);
  StageClock clock;
  const std::vector<Pose> T_map_scan = placeScans();
  close(retroactive_.searchLowDriftWindow(maps_, T_map_scan, maps_.back()->id, closed_), T_map_scan,
        result);
  clock.stage("retroactive");
  result.times = clock.times();
  return result;
}

/// As many as may be at a time. @return how many were tried.
std::size_t LoopDetector::close(const std::vector<RetroactiveCandidate>& candidates,
                                const std::vector<Pose>& T_map_scan,
                                LoopSearchResult& result) const {
  const auto placed = [&](LocalMapId id) {
    return placeByGraph(*maps_[id.value], T_map_scan, retroactive_closer_.association());
  };
  const PriorOf priors = priorsOf(T_map_scan);
  std::size_t done = 0;
  for (; done < candidates.size() && static_cast<int>(result.proposals.size()) < max_pairs_;
       ++done) {
    const auto& [source, target] = candidates[done].maps;
    const std::vector<LoopProposal> proposals =
        retroactive_closer_.close(placed(source), placed(target), LoopOrigin::retroactive, priors);
    result.proposals.insert(result.proposals.end(), proposals.begin(), proposals.end());
  }
  return done;
}

/// A pair whose loops the graph has rejected is not closed: a search may find the right one.
void LoopDetector::correct(const MapCorrectionPtr& correction) {
  correction_ = correction;
  closed_.clear();
  for (const LoopEdge& edge : correction->loops)
    if (edge.state != LoopState::rejected)
      closed_.insert({edge.loop.source_map, edge.loop.target_map});
}

bool LoopDetector::newestIsClosed() const {
  return std::any_of(closed_.begin(), closed_.end(),
                     [&](const LocalMapPair& pair) { return pair.first == maps_.back()->id; });
}

/// T_map_scan of all scans of the maps, by number: as the newest correction has them, those after
/// it as it carries them along.
std::vector<Pose> LoopDetector::placeScans() const {
  std::vector<Pose> T_map_scan;
  if (correction_) T_map_scan = correction_->T_map_scan;
  const Pose T_map_odom = correction_ ? correction_->T_map_odom : Pose::identity();
  for (const LocalMapPtr& map : maps_)
    for (const SubmapPtr& submap : map->submaps) {
      if (submap->lastScan().value < T_map_scan.size()) continue;
      const Pose T_map_submap = T_map_odom * submap->T_odom_submap;
      for (std::size_t i = T_map_scan.size() - submap->first_scan.value;
           i < submap->T_submap_scan.size(); ++i)
        T_map_scan.push_back(i == 0 ? T_map_submap : T_map_submap * submap->T_submap_scan[i]);
    }
  return T_map_scan;
}

}  // namespace revisit_slam
