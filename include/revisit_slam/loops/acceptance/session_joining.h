// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "revisit_slam/loops/acceptance/loop_closer.h"
#include "revisit_slam/loops/acceptance/pairwise_consistency.h"
#include "revisit_slam/types/scan_poses.h"
#include "revisit_slam/types/session_groups.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// When sessions are brought into one map.
struct JoiningConfig {
  int min_places = 2;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("min_places", min_places, Range{1, 1000}, "",
      "number of different local maps, in either session, whose loops have to agree before two "
      "sessions are joined (extend, merge). Raise it if sessions are joined where they do not "
      "belong; lower it if sessions share one place alone");
  }
};

/// Loops between sessions that no loop ties yet. Nothing is known of where one lies in the other,
/// so that none is believed by itself, but those that agree with each other (pairwise consistency,
/// with what the odometry of both sessions drifts in between), if they show enough places and more
/// than any that contradict them.
class SessionJoining {
 public:
  static constexpr const char* kGate = "joining";

  SessionJoining(const JoiningConfig& config, const PairwiseConsistencyConfig& consistency)
      : config_(config), consistency_(consistency) {}

  void reconfigure(const JoiningConfig& config, const PairwiseConsistencyConfig& consistency) {
    config_ = config;
    consistency_ = consistency;
  }

  /// A loop by appearance that has passed the gates. @return the same, as not believed yet.
  LoopProposal hold(LoopProposal proposal);

  /// The loops that are believed by now, first the one that most agree with. They are held no
  /// longer, as are all between sessions that are tied already.
  std::vector<LoopProposal> takeBelieved(const ScanPoses& T_map_scan, SessionGroups groups);

  std::size_t held() const { return held_.size(); }

 private:
  JoiningConfig config_;
  PairwiseConsistencyConfig consistency_;
  std::vector<LoopProposal> held_;  // in the order in which they came
};

}  // namespace revisit_slam
