// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/revisit_cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "revisit_slam/evaluation/pose_interpolator.h"

namespace revisit_slam {
namespace {

/// Poses in one cell, one after the other.
struct Run {
  Eigen::Vector2i cell;
  StampInterval interval;
  double height_sum = 0.0;
  std::size_t poses = 0;
};

/// The trajectory cut wherever it enters another cell or has a gap.
std::vector<Run> cutIntoRuns(const Trajectory& trajectory, double cell_size) {
  const Eigen::Vector2d origin = trajectory.front().T_world_base.translation.head<2>();
  std::vector<Run> runs;
  Stamp previous;
  for (const auto& [stamp, T_world_base] : trajectory) {
    const Eigen::Vector3d& p = T_world_base.translation;
    const Eigen::Vector2i cell =
        ((p.head<2>() - origin) / cell_size).array().round().cast<int>().matrix();
    const bool after_gap =
        !runs.empty() && secondsBetween(previous, stamp) > PoseInterpolator::kLongestGap;
    if (!runs.empty() && !after_gap) runs.back().interval.end = stamp;
    if (runs.empty() || after_gap || runs.back().cell != cell)
      runs.push_back({cell, {stamp, stamp}});
    runs.back().interval.end = {stamp.nanoseconds + 1};
    runs.back().height_sum += p.z();
    ++runs.back().poses;
    previous = stamp;
  }
  return runs;
}

RevisitSegment segmentOf(const std::vector<Run>& runs) {
  RevisitSegment segment;
  double height_sum = 0.0;
  std::size_t poses = 0;
  for (const Run& run : runs) {
    segment.intervals.push_back(run.interval);
    height_sum += run.height_sum;
    poses += run.poses;
  }
  segment.mean_height = height_sum / static_cast<double>(poses);
  return segment;
}

std::vector<RevisitSegment> segmentsOf(const std::vector<Run>& runs, double min_time_between) {
  std::vector<RevisitSegment> segments;
  std::vector<Run> current;
  for (const Run& run : runs) {
    const bool again = !current.empty() && secondsBetween(current.back().interval.end,
                                                          run.interval.begin) >= min_time_between;
    if (again) segments.push_back(segmentOf(std::exchange(current, {})));
    current.push_back(run);
  }
  segments.push_back(segmentOf(current));
  return segments;
}

bool isRevisit(const RevisitCell& cell, const ConsistencyConfig& config) {
  for (std::size_t a = 0; a < cell.segments.size(); ++a)
    for (std::size_t b = a + 1; b < cell.segments.size(); ++b)
      if (areComparable(cell.segments[a], cell.segments[b], config)) return true;
  return false;
}

}  // namespace

bool areComparable(const RevisitSegment& a, const RevisitSegment& b,
                   const ConsistencyConfig& config) {
  return std::abs(a.mean_height - b.mean_height) <= config.max_height_difference;
}

std::vector<RevisitCell> findRevisits(const Trajectory& trajectory,
                                      const ConsistencyConfig& config) {
  if (trajectory.empty()) return {};
  std::map<std::pair<int, int>, std::vector<Run>> by_cell;
  for (const Run& run : cutIntoRuns(trajectory, config.cell_size))
    by_cell[{run.cell.x(), run.cell.y()}].push_back(run);

  const Eigen::Vector2d origin = trajectory.front().T_world_base.translation.head<2>();
  std::vector<RevisitCell> revisits;
  for (const auto& [index, runs] : by_cell) {
    const Eigen::Vector2i cell(index.first, index.second);
    RevisitCell revisit{cell, origin + config.cell_size * cell.cast<double>(),
                        segmentsOf(runs, config.min_time_between)};
    if (isRevisit(revisit, config)) revisits.push_back(std::move(revisit));
  }
  std::sort(revisits.begin(), revisits.end(), [](const RevisitCell& a, const RevisitCell& b) {
    return a.segments[0].intervals[0].begin < b.segments[0].intervals[0].begin;
  });
  return revisits;
}

}  // namespace revisit_slam
