// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "revisit_slam/evaluation/consistency_config.h"
#include "revisit_slam/io/trajectory.h"

namespace revisit_slam {

/// begin <= t < end.
struct StampInterval {
  Stamp begin, end;
};

/// One traversal of a cell; several intervals where the border was crossed to and fro.
struct RevisitSegment {
  std::vector<StampInterval> intervals;
  double mean_height = 0.0;  ///< z of the trajectory, m
};

/// A cell of the xy grid with two or more traversals (paper Sec. IV-C).
struct RevisitCell {
  Eigen::Vector2i index = Eigen::Vector2i::Zero();
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< in the frame of the trajectory, m
  std::vector<RevisitSegment> segments;              ///< in order of time
};

/// Whether two traversals are on the same floor, and hence are compared.
bool areComparable(const RevisitSegment& a, const RevisitSegment& b,
                   const ConsistencyConfig& config);

/// The cells of which at least two traversals are comparable, in the order in which they were first
/// entered. The first pose is in the middle of cell (0, 0). Poses are in order of time, z up, and
/// denser than cells; an interval ends at a gap longer than PoseInterpolator::kLongestGap.
std::vector<RevisitCell> findRevisits(const Trajectory& trajectory,
                                      const ConsistencyConfig& config);

}  // namespace revisit_slam
