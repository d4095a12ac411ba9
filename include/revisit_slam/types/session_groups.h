// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "revisit_slam/types/loop_edge.h"

namespace revisit_slam {

/// Which sessions lie in one map: those that loops tie to each other, directly or over others.
class SessionGroups {
 public:
  SessionGroups() = default;
  /// As the active ones of these loops tie them.
  explicit SessionGroups(const std::vector<LoopEdge>& loops) {
    for (const LoopEdge& edge : loops)
      if (edge.state == LoopState::active) join(edge.loop.source.session, edge.loop.target.session);
  }

  /// The lowest session of the group that a session is in.
  SessionId of(SessionId session) const {
    for (auto up = above_.find(session); up != above_.end(); up = above_.find(session))
      session = up->second;
    return session;
  }
  bool areTied(SessionId a, SessionId b) const { return of(a) == of(b); }

  void join(SessionId a, SessionId b) {
    const SessionId group_a = of(a), group_b = of(b);
    if (group_a != group_b) above_[std::max(group_a, group_b)] = std::min(group_a, group_b);
  }

 private:
  std::map<SessionId, SessionId> above_;  // a lower one of its group; none: it is the lowest
};

}  // namespace revisit_slam
