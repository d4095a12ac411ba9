// SPDX-License-Identifier: MIT
#include <tbb/task_arena.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "candidate_file.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/session/session_summary.h"
#include "steps.h"

namespace revisit_slam {
namespace {

/// The places of all sessions, each session with the number of its place in the list.
class Places {
 public:
  Places(const std::vector<std::string>& summaries, double pixel) {
    for (const std::string& path : summaries) {
      SessionSummary summary = readSummary(path);
      for (StoredLocalMap& stored : summary.places) add(summary.name, std::move(stored), pixel);
      names_.push_back(summary.name);
    }
  }

  const std::vector<PlaceView>& views() const { return views_; }
  /// Of the first sessions.
  std::size_t countOf(std::size_t sessions) const {
    return static_cast<std::size_t>(
        std::count_if(views_.begin(), views_.end(),
                      [&](const PlaceView& view) { return view.id.session.value < sessions; }));
  }

  Candidate named(PlaceMatch match) const {
    Candidate candidate{names_[match.source.session.value], names_[match.target.session.value],
                        std::move(match)};
    candidate.match.source.session = candidate.match.target.session = {};
    return candidate;
  }

 private:
  void add(const std::string& name, StoredLocalMap stored, double pixel) {
    if (stored.features.size() > 0 && stored.pixel != pixel)
      throw std::runtime_error("loops/recognition/image/resolution of '" + name + "' was " +
                               std::to_string(stored.pixel));
    PlaceView view;
    view.id = {stored.id.value, SessionId{static_cast<std::uint32_t>(names_.size())}};
    view.T_level_local = stored.T_level_local;
    view.features = std::move(stored.features);
    views_.push_back(std::move(view));
  }

  std::vector<std::string> names_;
  std::vector<PlaceView> views_;
};

}  // namespace

void findCandidates(const CandidatesOptions& options, const SlamConfig& config) {
  const Places places(options.summaries, config.loops.recognition.image.resolution);
  PlaceCandidatesConfig how = options.config;
  if (options.exhaustive) how.shortlist = 0;
  how.queries = places.countOf(options.of);
  std::vector<Candidate> candidates;
  tbb::task_arena(config.background.threads).execute([&] {
    for (const PlaceMatch& match :
         findPlaceCandidates(places.views(), config.loops.recognition, how))
      candidates.push_back(places.named(match));
  });
  writeWholeText(options.out, candidateText(candidates));
  std::cout << places.views().size() << " places, " << candidates.size() << " candidates\n";
}

}  // namespace revisit_slam
