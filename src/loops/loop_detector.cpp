// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/loop_detector.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

namespace revisit_slam {
namespace {

/// Two maps with so many partners in common are tied on several ways, which would not agree were
/// one of them wrong.
constexpr std::size_t kCommonPartners = 3;

std::size_t inCommon(const std::set<LocalMapId>& a, const std::set<LocalMapId>& b) {
  return static_cast<std::size_t>(
      std::count_if(a.begin(), a.end(), [&](LocalMapId map) { return b.count(map) > 0; }));
}

void tie(const LocalMapPair& maps, std::map<LocalMapId, std::set<LocalMapId>>& partners) {
  if (maps.first == maps.second) return;
  partners[maps.first].insert(maps.second);
  partners[maps.second].insert(maps.first);
}

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
                           const InformationConfig& information,
                           std::shared_ptr<SubmapLibrary> library)
    : enabled_(loops.enabled),
      drift_(loops.closer.drift),
      max_pairs_(static_cast<std::size_t>(retroactive.max_pairs)),
      max_partners_(static_cast<std::size_t>(retroactive.max_partners)),
      search_at_end_(retroactive.search_at_end),
      recognition_(loops.recognition),
      appearance_closer_(loops.closer, information),
      retroactive_closer_(closerConfig(loops, retroactive), information),
      retroactive_(searchConfig(loops, retroactive)),
      joining_(loops.joining, loops.closer.consistency),
      library_(std::move(library)) {}

void LoopDetector::reconfigure(const LoopsConfig& loops, const RetroactiveConfig& retroactive) {
  drift_ = loops.closer.drift;
  max_pairs_ = static_cast<std::size_t>(retroactive.max_pairs);
  max_partners_ = static_cast<std::size_t>(retroactive.max_partners);
  recognition_.reconfigure(loops.recognition);
  appearance_closer_.reconfigure(loops.closer);
  retroactive_closer_.reconfigure(closerConfig(loops, retroactive));
  retroactive_.reconfigure(searchConfig(loops, retroactive));
  joining_.reconfigure(loops.joining, loops.closer.consistency);
}

void LoopDetector::add(const LocalMapPtr& map) {
  order_.append(map->id);
  maps_.push_back(withoutPoints(map));
  for (const SubmapPtr& submap : map->submaps)
    for (ScanId scan = submap->first_scan; scan.value <= submap->lastScan().value; ++scan.value)
      scans_.append(scan);
}

LocalMapPtr LoopDetector::withoutPoints(const LocalMapPtr& map) const {
  if (!library_ || !library_->has(map->submaps.front()->id)) return map;
  auto light = std::make_shared<LocalMap>();
  light->id = map->id;
  light->after_loss = map->after_loss;
  for (const SubmapPtr& submap : map->submaps)
    light->submaps.push_back(library_->light(submap->id));
  return light;
}

/// With the points of its submaps, of those that can be read.
LocalMapPtr LoopDetector::mapOf(LocalMapId id) const {
  const LocalMapPtr& map = maps_.at(order_[id]);
  if (!library_ || !library_->has(map->submaps.front()->id)) return map;
  auto whole = std::make_shared<LocalMap>();
  whole->id = map->id;
  whole->after_loss = map->after_loss;
  std::exception_ptr error;
  std::size_t read = 0;
  for (const SubmapPtr& submap : map->submaps) {
    try {
      whole->submaps.push_back(library_->whole(submap->id));
      ++read;
    } catch (const std::runtime_error&) {
      // Its file is gone, those of others may be there. The map's frame is that of the first.
      whole->submaps.push_back(submap);
      error = std::current_exception();
    }
  }
  if (read == 0 && error) std::rethrow_exception(error);
  return whole;
}

void LoopDetector::addSearched(const LocalMapPtr& map, const PlaceView& view) {
  add(map);
  recognition_.add(map->id, view.T_level_local, view.features);
  views_[map->id] = view;
  searched_ = map->id;
}

LoopSearchResult LoopDetector::newSearch(LoopOrigin origin) const {
  LoopSearchResult result;
  result.origin = origin;
  result.map = maps_.back();
  return result;
}

LoopSearchResult LoopDetector::searchByAppearance(const LocalMapPtr& map) {
  add(map);
  LoopSearchResult result = newSearch(LoopOrigin::appearance);
  result.map = map;
  if (!enabled_) return result;
  StageClock clock;
  recognition_.recognise(*map);
  result.candidates = recognition_.candidates();
  result.view = std::make_shared<const PlaceView>(recognition_.lastView());
  clock.stage("recognition");
  closeMatches(*map, result);
  clock.stage("registration");
  result.times = clock.times();
  return result;
}

LoopSearchResult LoopDetector::searchAcrossSessions(LocalMapId map, SessionId first) {
  LoopSearchResult result = newSearch(LoopOrigin::appearance);
  if (!enabled_) return result;
  StageClock clock;
  for (const PlaceMatch& match : recognition_.find(views_.at(map)))
    if (match.target.session < first) result.candidates.push_back(match);
  clock.stage("recognition");
  closeMatches(*mapOf(map), result);
  clock.stage("registration");
  result.times = clock.times();
  return result;
}

/// The best place among the sessions that are tied to the source's own, and among each group of
/// others.
void LoopDetector::closeMatches(const LocalMap& source, LoopSearchResult& result) {
  std::set<SessionId> closed;  // groups
  for (const PlaceMatch& match : result.candidates) {
    if (!recognition_.isRecognised(match)) break;
    if (!closed.insert(groups_.of(match.target.session)).second) continue;
    if (!result.match) result.match = match;
    const bool is_tied = groups_.areTied(source.id.session, match.target.session);
    for (LoopProposal& proposal : closeByAppearance(source, match)) {
      proposal.loop.inliers = match.inliers;
      const bool waits = !is_tied && proposal.verdict.isAccepted();
      result.proposals.push_back(waits ? joining_.hold(std::move(proposal)) : std::move(proposal));
    }
  }
  believe(result);
}

/// Loops between sessions that agree by now.
void LoopDetector::believe(LoopSearchResult& result) {
  if (joining_.held() == 0) return;
  const std::vector<LoopProposal> believed = joining_.takeBelieved(placeScans(), groups_);
  const auto is_believed = [&](const LoopProposal& proposal) {
    return std::any_of(believed.begin(), believed.end(), [&](const LoopProposal& other) {
      return other.loop.source == proposal.loop.source && other.loop.target == proposal.loop.target;
    });
  };
  result.proposals.erase(
      std::remove_if(result.proposals.begin(), result.proposals.end(), is_believed),
      result.proposals.end());
  result.proposals.insert(result.proposals.end(), believed.begin(), believed.end());
}

/// The place that was recognised says where the local maps are to each other; within them submaps
/// are where the odometry or the graph has them.
std::vector<LoopProposal> LoopDetector::closeByAppearance(const LocalMap& source,
                                                          const PlaceMatch& match) const {
  const LocalMapPtr whole = mapOf(match.target);
  const LocalMap& target = *whole;
  const AssociationConfig& association = appearance_closer_.association();
  const ScanPoses T_map_scan = placeScans();
  const PriorOf priors = priorsOf(T_map_scan);
  if (!association.usesOptimisedTrajectories())
    return appearance_closer_.close(source, target, match.T_target_source, LoopOrigin::appearance,
                                    priors);
  const auto placed = [&](const LocalMap& map, const Pose& T_common_local) {
    const Pose& T_map_local = T_map_scan[map.submaps.front()->first_scan];
    return moved(placeByGraph(map, T_map_scan, association),
                 T_common_local * T_map_local.inverse());
  };
  return appearance_closer_.close(placed(source, match.T_target_source),
                                  placed(target, Pose::identity()), LoopOrigin::appearance, priors);
}

GraphDrift LoopDetector::graphDrift() const {
  std::vector<SubmapPtr> submaps;
  for (const LocalMapPtr& map : maps_)
    submaps.insert(submaps.end(), map->submaps.begin(), map->submaps.end());
  return {std::move(submaps), correction_ ? correction_->loops : std::vector<LoopEdge>{}, drift_};
}

/// Where the graph has the submaps, and how far it may be off.
PriorOf LoopDetector::priorsOf(const ScanPoses& T_map_scan) const {
  const auto drift = std::make_shared<const GraphDrift>(graphDrift());
  return [drift, &T_map_scan](const Submap& source, const Submap& target) {
    return LoopPrior{T_map_scan[target.first_scan].inverse() * T_map_scan[source.first_scan],
                     drift->between(source.id, target.id)};
  };
}

LoopSearchResult LoopDetector::searchRetroactively(std::optional<LocalMapId> n) {
  LoopSearchResult result = newSearch(LoopOrigin::retroactive);
  const LocalMapId last = n.value_or(maps_.back()->id);
  if (searchWindow(last, max_pairs_, tried_, result)) {
    searched_ = last;
    tried_.clear();
  }
  return result;
}

LoopSearchResult LoopDetector::searchUnspent(TriedPairs& tried, std::size_t batches) {
  LoopSearchResult result = newSearch(LoopOrigin::retroactive);
  believe(result);
  if (result.proposals.empty() && search_at_end_)
    searchWindow(maps_.back()->id, batches * max_pairs_, tried, result);
  return result;
}

/// Until there are `most` proposals. @return whether no pairs are left.
bool LoopDetector::searchWindow(LocalMapId n, std::size_t most, TriedPairs& tried,
                                LoopSearchResult& result) const {
  StageClock clock;
  const ScanPoses T_map_scan = placeScans();
  std::vector<RetroactiveCandidate> candidates =
      retroactive_.search(maps_, T_map_scan, searched_, n, closed_);
  const auto is_left_out = [&](const RetroactiveCandidate& candidate) {
    const auto& [source, target] = candidate.maps;
    return tried.has(candidate.maps) || !groups_.areTied(source.session, target.session) ||
           areWellTied(candidate.maps, partners_);
  };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_left_out),
                   candidates.end());
  const std::vector<LocalMapPair> done = close(candidates, most, T_map_scan, result);
  const GraphDrift drift = graphDrift();
  for (const LocalMapPair& maps : done) tried.note(maps, guessOf(maps, T_map_scan, drift));
  clock.stage("retroactive");
  result.times = clock.times();
  return done.size() == candidates.size();
}

/// Both, by loops with others, and so with each other: one more tells hardly anything. Over laps of
/// one place the pairs would grow with the square of the laps.
bool LoopDetector::areWellTied(const LocalMapPair& maps, const Partners& partners) const {
  const auto first = partners.find(maps.first), second = partners.find(maps.second);
  if (first == partners.end() || second == partners.end()) return false;
  return first->second.size() >= max_partners_ && second->second.size() >= max_partners_ &&
         inCommon(first->second, second->second) >= std::min(max_partners_, kCommonPartners);
}

void LoopDetector::forgetChanged(TriedPairs& tried) const {
  const ScanPoses T_map_scan = placeScans();
  const GraphDrift drift = graphDrift();
  tried.forgetChanged([&](const LocalMapPair& maps) { return guessOf(maps, T_map_scan, drift); });
}

PairGuess LoopDetector::guessOf(const LocalMapPair& maps, const ScanPoses& T_map_scan,
                                const GraphDrift& drift) const {
  const std::vector<SubmapPtr>&source = maps_[order_[maps.first]]->submaps,
        &target = maps_[order_[maps.second]]->submaps;
  const auto T_target_source = [&](const SubmapPtr& to, const SubmapPtr& from) {
    return T_map_scan[to->first_scan].inverse() * T_map_scan[from->first_scan];
  };
  return {T_target_source(target.front(), source.front()),
          T_target_source(target.back(), source.back()),
          drift.between(source.front()->id, target.front()->id).plane};
}

/// What is not closed now may be once the graph has moved it: it does not count as tried.
LoopSearchResult LoopDetector::searchLowDriftWindow() {
  LoopSearchResult result = newSearch(LoopOrigin::retroactive);
  StageClock clock;
  const ScanPoses T_map_scan = placeScans();
  close(retroactive_.searchLowDriftWindow(maps_, T_map_scan, maps_.back()->id, closed_), max_pairs_,
        T_map_scan, result);
  clock.stage("retroactive");
  result.times = clock.times();
  return result;
}

/// Until there are `most` proposals. What these would tie well is left until the graph has taken
/// them. @return the pairs that were tried.
std::vector<LocalMapPair> LoopDetector::close(const std::vector<RetroactiveCandidate>& candidates,
                                              std::size_t most, const ScanPoses& T_map_scan,
                                              LoopSearchResult& result) const {
  const auto placed = [&](LocalMapId id) {
    return placeByGraph(*mapOf(id), T_map_scan, retroactive_closer_.association());
  };
  const PriorOf priors = priorsOf(T_map_scan);
  std::vector<LocalMapPair> tried;
  Partners partners = partners_;
  for (const RetroactiveCandidate& candidate : candidates) {
    if (result.proposals.size() >= most) break;
    if (areWellTied(candidate.maps, partners)) continue;
    const auto& [source, target] = candidate.maps;
    tried.push_back(candidate.maps);
    for (LoopProposal& proposal : retroactive_closer_.close(placed(source), placed(target),
                                                            LoopOrigin::retroactive, priors)) {
      if (proposal.verdict.isAccepted()) tie(candidate.maps, partners);
      result.proposals.push_back(std::move(proposal));
    }
  }
  return tried;
}

/// A pair whose loops the graph has rejected is not closed: a search may find the right one.
void LoopDetector::correct(const MapCorrectionPtr& correction) {
  const bool is_first = !correction_;  // tells what sessions that were mapped before are
  correction_ = correction;
  closed_.clear();
  for (const LoopEdge& edge : correction->loops)
    if (edge.state != LoopState::rejected)
      closed_.insert({edge.loop.source_map, edge.loop.target_map});
  partners_.clear();
  for (const LocalMapPair& maps : closed_) tie(maps, partners_);
  const SessionGroups groups(correction->loops);
  if (!is_first) searchAgainWhatWasJoined(groups);
  groups_ = groups;
}

/// From the first map on of the first session that lies in another map than before.
void LoopDetector::searchAgainWhatWasJoined(const SessionGroups& groups) {
  for (const SessionId session : order_.sessions()) {
    if (groups.of(session) == groups_.of(session)) continue;
    const std::size_t first = order_.begin(session);
    if (first == 0)
      searched_.reset();
    else if (searched_ && order_[*searched_] >= first)
      searched_ = maps_[first - 1]->id;
    tried_.clear();
    return;
  }
}

bool LoopDetector::newestIsClosed() const {
  return std::any_of(closed_.begin(), closed_.end(),
                     [&](const LocalMapPair& pair) { return pair.first == maps_.back()->id; });
}

/// T_map_scan of all scans of the maps: as the newest correction has them, those after it as it
/// carries them along.
ScanPoses LoopDetector::placeScans() const {
  std::vector<Pose> T_map_scan;
  if (correction_) T_map_scan = correction_->T_map_scan;
  for (const LocalMapPtr& map : maps_)
    for (const SubmapPtr& submap : map->submaps) {
      if (scans_[submap->lastScan()] < T_map_scan.size()) continue;
      const bool is_carried = correction_ && correction_->session == map->id.session;
      const Pose T_map_odom = is_carried ? correction_->T_map_odom : Pose::identity();
      const Pose T_map_submap = T_map_odom * submap->T_odom_submap;
      for (std::size_t i = T_map_scan.size() - scans_[submap->first_scan];
           i < submap->T_submap_scan.size(); ++i)
        T_map_scan.push_back(i == 0 ? T_map_submap : T_map_submap * submap->T_submap_scan[i]);
    }
  return {std::move(T_map_scan), scans_};
}

}  // namespace revisit_slam
