// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_candidates.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kPlacesAtATime = 16;

/// The later session is the source, as in a single drive the later local map is.
PlaceMatch directed(PlaceMatch match) {
  if (match.target < match.source) return match;
  std::swap(match.source, match.target);
  match.T_target_source = match.T_target_source.inverse();
  return match;
}

class CandidateSearch {
 public:
  CandidateSearch(const std::vector<PlaceView>& places, const PlaceRecognitionConfig& recognition,
                  const PlaceCandidatesConfig& config)
      : places_(places), config_(config), recognition_(recognition) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      recognition_.add(places[i].id, places[i].T_level_local, places[i].features);
      const auto session = ranges_.try_emplace(places[i].id.session, i, i + 1).first;
      session->second.second = i + 1;
    }
  }

  std::vector<PlaceMatch> run(const std::function<void(std::size_t)>& on_places) const {
    std::vector<const PlaceFeatures*> features;
    for (const PlaceView& place : places_) features.push_back(&place.features);
    PlaceIndexConfig index_config = config_.index;
    if (config_.shortlist == 0) index_config.tables = 0;
    const PlaceIndex index(features, index_config);
    const Chunks chunks(config_.queries > 0 ? config_.queries : places_.size(), kPlacesAtATime);
    std::vector<std::vector<PlaceMatch>> found(chunks.size());
    std::atomic<std::size_t> done{0};
    chunks.forEach([&](std::size_t number, Chunk chunk) {
      PlaceIndex::Lookup lookup(index);
      for (std::size_t i = chunk.begin; i < chunk.end; ++i)
        for (const PlaceMatch& match : matchesOf(i, index, lookup)) found[number].push_back(match);
      if (on_places) on_places(done += chunk.end - chunk.begin);
    });
    return unique(found);
  }

 private:
  /// Its best partners, the best place of each.
  std::vector<PlaceMatch> matchesOf(std::size_t place, const PlaceIndex& index,
                                    PlaceIndex::Lookup& lookup) const {
    std::vector<PlaceMatch> best;
    std::set<SessionId> partners;
    for (const PlaceMatch& match :
         recognition_.find(places_[place], toCompare(place, index, lookup))) {
      if (!recognition_.isRecognised(match)) break;
      if (partners.insert(match.target.session).second) best.push_back(directed(match));
      if (best.size() == static_cast<std::size_t>(config_.partners)) break;
    }
    return best;
  }

  std::vector<std::size_t> toCompare(std::size_t place, const PlaceIndex& index,
                                     PlaceIndex::Lookup& lookup) const {
    const auto [begin, end] = ranges_.at(places_[place].id.session);
    std::vector<std::size_t> others;
    if (config_.shortlist > 0) {
      for (const PlaceIndex::Vote& vote :
           index.similar(places_[place].features, begin, end,
                         static_cast<std::size_t>(config_.shortlist), lookup))
        others.push_back(vote.place);
      return others;
    }
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (i < begin || i >= end) others.push_back(i);
    return others;
  }

  /// A pair that both places have named is one: as the later one sees it.
  static std::vector<PlaceMatch> unique(const std::vector<std::vector<PlaceMatch>>& found) {
    std::map<std::pair<LocalMapId, LocalMapId>, PlaceMatch> pairs;
    for (const auto& matches : found)
      for (const PlaceMatch& match : matches) pairs[{match.source, match.target}] = match;
    std::vector<PlaceMatch> all;
    all.reserve(pairs.size());
    for (const auto& pair : pairs) all.push_back(pair.second);
    return all;
  }

  const std::vector<PlaceView>& places_;
  const PlaceCandidatesConfig& config_;
  PlaceRecognition recognition_;
  std::map<SessionId, std::pair<std::size_t, std::size_t>> ranges_;  // of places
};

}  // namespace

std::vector<PlaceMatch> findPlaceCandidates(const std::vector<PlaceView>& places,
                                            const PlaceRecognitionConfig& recognition,
                                            const PlaceCandidatesConfig& config,
                                            const std::function<void(std::size_t)>& on_places) {
  return CandidateSearch(places, recognition, config).run(on_places);
}

}  // namespace revisit_slam
