// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/search/loop_search.h"

namespace revisit_slam {

LoopSearch::LoopSearch(const LoopsConfig& config, const InformationConfig& information)
    : config_(config), recognition_(config.recognition), closer_(config.closer, information) {}

LoopSearchResult LoopSearch::search(const LocalMapPtr& map) {
  LoopSearchResult result;
  result.map = map;
  maps_.push_back(map);
  if (!config_.enabled) return result;
  StageClock clock;
  result.match = recognition_.recognise(*map);
  result.candidates = recognition_.candidates();
  result.view = std::make_shared<const PlaceView>(recognition_.lastView());
  clock.stage("recognition");
  if (result.match) {
    const LocalMap& target = *maps_.at(result.match->target.value);
    result.proposals =
        closer_.close(*map, target, result.match->T_target_source, LoopOrigin::appearance);
    for (LoopProposal& proposal : result.proposals) proposal.loop.inliers = result.match->inliers;
  }
  clock.stage("registration");
  result.times = clock.times();
  return result;
}

}  // namespace revisit_slam
