// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/session_joining.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace revisit_slam {
namespace {

/// A loop between two groups of sessions, from the later to the earlier one.
struct CrossLoop {
  std::size_t index;  // of those held
  RegisteredPair pair;
  LocalMapId earlier_map, later_map;
};

/// The common frame of targets is the map of the earlier group, that of sources the later group's.
CrossLoop crossLoop(std::size_t index, const LoopProposal& proposal, bool is_reverse,
                    const ScanPoses& T_map_scan) {
  const LoopConstraint& loop = proposal.loop;
  CrossLoop cross{index, proposal.registered, loop.target_map, loop.source_map};
  cross.pair.T_common_target = T_map_scan[loop.constraint.from];
  cross.pair.T_common_source = T_map_scan[loop.constraint.to];
  if (!is_reverse) return cross;
  std::swap(cross.pair.T_common_target, cross.pair.T_common_source);
  std::swap(cross.earlier_map, cross.later_map);
  Pose& T_target_source = cross.pair.registration.T_target_source;
  T_target_source = T_target_source.inverse();
  return cross;
}

/// Loops that agree with one of them.
struct Agreement {
  std::size_t centre = 0;
  std::vector<std::size_t> members;  // the centre first
  std::size_t places = 0;

  bool isStronger(const Agreement& other) const {
    return std::pair(places, members.size()) > std::pair(other.places, other.members.size());
  }
  bool contains(std::size_t loop) const {
    return std::find(members.begin(), members.end(), loop) != members.end();
  }
};

/// Different places in both groups: one that is passed again confirms nothing.
std::size_t placesOf(const std::vector<CrossLoop>& loops, const std::vector<std::size_t>& members) {
  std::set<LocalMapId> earlier, later;
  for (const std::size_t member : members) {
    earlier.insert(loops[member].earlier_map);
    later.insert(loops[member].later_map);
  }
  return std::min(earlier.size(), later.size());
}

/// The strongest one without the loops of `left_out`.
Agreement strongest(const std::vector<CrossLoop>& loops,
                    const PairwiseConsistencyConfig& consistency, const Agreement& left_out) {
  Agreement best;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (left_out.contains(i)) continue;
    Agreement agreement{i, {i}, 0};
    for (std::size_t k = 0; k < loops.size(); ++k)
      if (k != i && !left_out.contains(k) &&
          areConsistent(loops[i].pair, loops[k].pair, consistency))
        agreement.members.push_back(k);
    agreement.places = placesOf(loops, agreement.members);
    if (agreement.isStronger(best)) best = agreement;
  }
  return best;
}

}  // namespace

LoopProposal SessionJoining::hold(LoopProposal proposal) {
  held_.push_back(proposal);
  held_.back().registered.source.reset();  // their points would stay in memory
  held_.back().registered.target.reset();
  proposal.verdict.gate = kGate;
  proposal.verdict.measurement = {1.0, Bound::at_least, static_cast<double>(config_.min_places),
                                  ""};
  return proposal;
}

std::vector<LoopProposal> SessionJoining::takeBelieved(const ScanPoses& T_map_scan,
                                                       SessionGroups groups) {
  const auto is_tied = [&](const LoopProposal& proposal) {
    return groups.areTied(proposal.loop.source.session, proposal.loop.target.session);
  };
  held_.erase(std::remove_if(held_.begin(), held_.end(), is_tied), held_.end());
  std::map<std::pair<SessionId, SessionId>, std::vector<CrossLoop>> between;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const SessionId target = groups.of(held_[i].loop.target.session),
                    source = groups.of(held_[i].loop.source.session);
    between[std::minmax(target, source)].push_back(
        crossLoop(i, held_[i], source < target, T_map_scan));
  }
  std::vector<LoopProposal> believed;
  std::set<SessionId> moved;  // groups; where the others lie in them is not known yet
  for (const auto& [pair, loops] : between) {
    if (moved.count(pair.first) > 0 || moved.count(pair.second) > 0) continue;
    const Agreement best = strongest(loops, consistency_, {});
    const Agreement rival = strongest(loops, consistency_, best);
    if (best.places < static_cast<std::size_t>(config_.min_places) || best.places <= rival.places)
      continue;
    for (const std::size_t member : best.members) believed.push_back(held_[loops[member].index]);
    groups.join(pair.first, pair.second);
    moved.insert({pair.first, pair.second});
  }
  held_.erase(std::remove_if(held_.begin(), held_.end(), is_tied), held_.end());
  return believed;
}

}  // namespace revisit_slam
