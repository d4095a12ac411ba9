// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/pose_graph/chain_piece.h"
#include "revisit_slam/pose_graph/pose_graph.h"

namespace revisit_slam {

/// A small graph in place of one with long odometry chains: it has the ends of chains, the gauges
/// and all nodes that any other factor binds, one composed factor for each chain between them, and
/// these other factors with their kernels; what is settled is left out. Its minimum is that of the
/// whole graph for small corrections and a good start for large ones.
class ChainReduction {
 public:
  /// The graph must outlive the reduction.
  explicit ChainReduction(const PoseGraph& graph);

  const PoseGraph& reduced() const { return reduced_; }

  /// Poses of all nodes from those of the reduced graph; every chain bends between its ends.
  std::vector<Pose> expand(const std::vector<Pose>& reduced_poses) const;

 private:
  struct Piece {
    NodeId first, last;  ///< in the reduced graph
    ChainPiece links;
  };

  void keepNodes();
  void cutPieces();
  void compose();

  const PoseGraph& whole_;
  PoseGraph reduced_;
  std::vector<NodeId> kept_;        ///< reduced -> whole
  std::vector<NodeId> reduced_of_;  ///< whole -> reduced, or kNone
  std::vector<Piece> pieces_;
};

}  // namespace revisit_slam
