// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "revisit_slam/evaluation/map_consistency.h"
#include "revisit_slam/mapping/voxel_mean_grid.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Builds the local maps of revisited cells from points as they come, compares them without any
/// registration, and forgets them: what is in memory are the maps of cells that will be visited
/// again, one point (12 bytes) for each occupied voxel.
///
/// The points may be scans at their estimated poses, or closed submaps at their optimised keyposes
/// and the stamp of the keypose. A local map is made in the frame of the cell's first pose, so that
/// a rigid motion of the whole estimate does not change how points fall into voxels.
class ConsistencyBuilder {
 public:
  ConsistencyBuilder(std::vector<RevisitCell> revisits, const ConsistencyConfig& config);

  /// Whether some cell wants points of this instant.
  bool wants(Stamp stamp) const;

  /// `T_world_points` maps the points into the estimate's world. Stamps do not decrease: points of
  /// a segment that is already over are ignored. Runs in the current TBB arena.
  void insert(Stamp stamp, const Points& points, const Pose& T_world_points);

  /// Compares what is left.
  MapConsistency finish();

 private:
  struct Cell {
    RevisitCell revisit;
    std::optional<Pose> T_world_cell;  // once entered
    std::vector<VoxelMeanGrid> grids;  // of the segments
    std::vector<Points> maps;          // of those that are over
    std::size_t closed = 0;
  };
  struct Worst {
    double rms;
    CellMaps maps;
  };
  /// When which segment (of which cell) is passed through.
  struct Visit {
    StampInterval interval;
    std::size_t cell, segment;
  };

  const Visit* visitAt(Stamp stamp) const;
  void closeBefore(Stamp stamp);
  void closeSegment(const Visit& end);
  void compare(const Cell& cell, CellConsistency& result) const;
  void keepIfAmongTheWorst(Cell& cell, const NearestDistances& distances);

  ConsistencyConfig config_;
  std::vector<Cell> cells_;
  std::vector<Visit> visits_;  // by time
  std::vector<Visit> ends_;    // the last interval of every segment, by time
  std::size_t closed_ = 0;     // of ends_
  std::vector<CellConsistency> results_;
  std::vector<Worst> worst_;  // largest RMS first
};

}  // namespace revisit_slam
