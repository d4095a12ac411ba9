// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/slam/graph_session.h"
#include "revisit_slam/slam/loop_closing.h"
#include "revisit_slam/util/lane.h"

namespace revisit_slam {

/// What loops and graph get of a drive of one session from the stages before.
struct MappedDrive {
  std::vector<GraphNode> nodes;   ///< by number of the scan
  std::vector<LocalMapPtr> maps;  ///< by number
};

/// Closes the loops of a drive that is mapped already: to see what loops and graph make of the same
/// maps with other parameters. The same bits as Slam, whose stages before it are left out.
class LoopReplay {
 public:
  /// Of `config` those parameters count that act after the maps: loops, retroactive, backend, and
  /// information/enabled, which puts the identity in the place of all information.
  LoopReplay(const MappedDrive& drive, const SlamConfig& config);

  const SlamGraph& graph() const { return session_.graph(); }

 private:
  LoopClosing::Outputs outputs();

  InlineLane lane_;
  GraphSession session_;
  LoopClosing closing_;
};

}  // namespace revisit_slam
