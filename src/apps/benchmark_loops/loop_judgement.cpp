// SPDX-License-Identifier: MIT
#include "loop_judgement.h"

#include <algorithm>
#include <map>

namespace revisit_slam {
namespace {

double lengthOf(const Stretch& stretch) {
  double length = 0.0;
  for (std::size_t i = 1; i < stretch.T_world_scan.size(); ++i)
    length +=
        (stretch.T_world_scan[i].translation - stretch.T_world_scan[i - 1].translation).norm();
  return length;
}

/// Of the last map in `stretches` with those that it may be matched with.
std::vector<LabelledPair> labelEarlier(const std::vector<Stretch>& stretches,
                                       std::size_t newest_excluded) {
  std::vector<LabelledPair> pairs;
  for (std::size_t i = 0; i + 1 + newest_excluded < stretches.size(); ++i)
    pairs.push_back({{static_cast<std::uint32_t>(i)}, labelOf(stretches.back(), stretches[i])});
  return pairs;
}

std::optional<LabelledPair> mostShared(const std::vector<LabelledPair>& pairs) {
  const auto best = std::max_element(pairs.begin(), pairs.end(),
                                     [](const LabelledPair& a, const LabelledPair& b) {
                                       return a.label.sharedPath() < b.label.sharedPath();
                                     });
  if (best == pairs.end() || !best->label.isRevisit()) return std::nullopt;
  return *best;
}

JudgedMatch judgeMatch(const PlaceMatch& match, const std::vector<LabelledPair>& earlier,
                       const LoopLimits& limits) {
  JudgedMatch judged{match, earlier.at(match.target.value).label, {}, false};
  judged.error = errorAtPlace(match.T_target_source, judged.label);
  judged.is_right = judged.error.within(limits.map_translation, limits.map_rotation);
  return judged;
}

JudgedMap judgeMap(const MapClosure& closure, const std::vector<Stretch>& stretches,
                   std::size_t newest_excluded, const LoopLimits& limits) {
  JudgedMap judged;
  judged.id = closure.search.map->id;
  judged.length = lengthOf(stretches.back());
  judged.earlier = labelEarlier(stretches, newest_excluded);
  judged.revisit = mostShared(judged.earlier);
  for (const PlaceMatch& candidate : closure.search.candidates)
    judged.candidates.push_back(judgeMatch(candidate, judged.earlier, limits));
  judged.is_confirmed = !closure.search.accepted().empty();
  if (closure.search.match)
    judged.match = judgeMatch(*closure.search.match, judged.earlier, limits);
  return judged;
}

/// Judges proposals, with the submaps of the drive by SubmapId.
class ConstraintJudge {
 public:
  ConstraintJudge(const ClosedDrive& closed, const PoseInterpolator& truth,
                  const LoopLimits& limits)
      : limits_(limits) {
    for (const MapClosure& closure : closed.maps)
      for (const SubmapPtr& submap : closure.search.map->submaps)
        stretches_.push_back(stretchOf(*submap, truth));
    for (const LoopEdge& edge : closed.edges)
      states_[{edge.loop.source, edge.loop.target}] = toString(edge.state);
  }

  JudgedConstraint operator()(const LoopProposal& proposal) const {
    const LoopConstraint& loop = proposal.loop;
    JudgedConstraint judged;
    judged.proposal = proposal;
    judged.label = labelOf(stretches_.at(loop.source.value), stretches_.at(loop.target.value));
    judged.at_keypose = errorAtKeypose(loop.constraint.T_from_to, judged.label);
    judged.at_place = errorAtPlace(loop.constraint.T_from_to, judged.label);
    const auto is_right = [&](const LoopError& error) {
      return error.within(limits_.constraint_translation, limits_.constraint_rotation);
    };
    judged.is_right = is_right(judged.at_place);
    judged.is_right_at_keypose = is_right(judged.at_keypose);
    if (proposal.verdict.isAccepted()) judged.state = states_.at({loop.source, loop.target});
    return judged;
  }

 private:
  LoopLimits limits_;
  std::vector<Stretch> stretches_;
  std::map<std::pair<SubmapId, SubmapId>, std::string> states_;
};

}  // namespace

Judgement judge(const ClosedDrive& closed, const PoseInterpolator& truth,
                std::size_t newest_excluded, const LoopLimits& limits) {
  Judgement judgement;
  std::vector<Stretch> stretches;
  const ConstraintJudge judge_constraint(closed, truth, limits);
  const auto add = [&](const std::vector<LoopProposal>& proposals) {
    for (const LoopProposal& proposal : proposals)
      judgement.constraints.push_back(judge_constraint(proposal));
  };
  for (const MapClosure& closure : closed.maps) {
    stretches.push_back(stretchOf(*closure.search.map, truth));
    judgement.maps.push_back(judgeMap(closure, stretches, newest_excluded, limits));
    add(closure.search.proposals);
    add(closure.retroactive);
  }
  add(closed.at_the_end);
  return judgement;
}

}  // namespace revisit_slam
