// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/pose_graph/chain_piece.h"
#include "revisit_slam/pose_graph/pose_graph.h"

namespace revisit_slam {

/// A small graph in place of one with long odometry chains: it has the nodes where loops, ends and
/// gauges are, and one composed constraint for each chain between them. Its minimum is that of the
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
    ScanId first, last;  ///< in the reduced graph
    ChainPiece constraints;
  };

  void keepNodes(const PoseGraph& graph);
  void cutPieces(const PoseGraph& graph);
  void compose(const PoseGraph& graph);

  PoseGraph reduced_;
  std::vector<ScanId> kept_;               ///< reduced -> whole
  std::vector<std::uint32_t> reduced_of_;  ///< whole -> reduced, or kInner
  std::vector<Piece> pieces_;
};

}  // namespace revisit_slam
