// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/consistency_builder.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace revisit_slam {
namespace {

Points pointsWithin(double radius, const Eigen::Vector3d& centre, const Points& points) {
  const Eigen::Vector3f c = centre.cast<float>();
  const auto limit = static_cast<float>(radius * radius);
  Points kept;
  kept.reserve(points.size());
  for (const Eigen::Vector3f& point : points)
    if ((point - c).squaredNorm() <= limit) kept.push_back(point);
  return kept;
}

}  // namespace

ConsistencyBuilder::ConsistencyBuilder(std::vector<RevisitCell> revisits,
                                       const ConsistencyConfig& config)
    : config_(config), results_(revisits.size()) {
  for (std::size_t cell = 0; cell < revisits.size(); ++cell) {
    const std::vector<RevisitSegment>& segments = revisits[cell].segments;
    for (std::size_t segment = 0; segment < segments.size(); ++segment) {
      for (const StampInterval& interval : segments[segment].intervals)
        visits_.push_back({interval, cell, segment});
      ends_.push_back(visits_.back());
    }
    results_[cell].cell = revisits[cell];
    cells_.push_back({revisits[cell], {}, {}, std::vector<Points>(segments.size())});
    cells_.back().grids.assign(segments.size(), VoxelMeanGrid(config.voxel_size));
  }
  const auto earlier = [](const Visit& a, const Visit& b) {
    return a.interval.begin < b.interval.begin;
  };
  std::sort(visits_.begin(), visits_.end(), earlier);
  std::sort(ends_.begin(), ends_.end(), earlier);
}

const ConsistencyBuilder::Visit* ConsistencyBuilder::visitAt(Stamp stamp) const {
  const auto next =
      std::upper_bound(visits_.begin(), visits_.end(), stamp,
                       [](Stamp s, const Visit& visit) { return s < visit.interval.begin; });
  if (next == visits_.begin() || stamp >= (next - 1)->interval.end) return nullptr;
  return &*(next - 1);
}

bool ConsistencyBuilder::wants(Stamp stamp) const {
  return visitAt(stamp) != nullptr;
}

void ConsistencyBuilder::insert(Stamp stamp, const Points& points, const Pose& T_world_points) {
  closeBefore(stamp);
  const Visit* visit = visitAt(stamp);
  if (visit == nullptr) return;
  Cell& cell = cells_[visit->cell];
  if (!cell.T_world_cell) cell.T_world_cell = T_world_points;
  const Pose T_cell_points = cell.T_world_cell->inverse() * T_world_points;
  const Eigen::Vector3d centre = T_cell_points.inverse().translation;
  cell.grids[visit->segment].insert(pointsWithin(config_.radius, centre, points), T_cell_points);
}

void ConsistencyBuilder::closeBefore(Stamp stamp) {
  for (; closed_ < ends_.size() && ends_[closed_].interval.end <= stamp; ++closed_)
    closeSegment(ends_[closed_]);
}

void ConsistencyBuilder::closeSegment(const Visit& end) {
  Cell& cell = cells_[end.cell];
  cell.maps[end.segment] = cell.grids[end.segment].take().points;
  if (++cell.closed < cell.maps.size()) return;
  compare(cell, results_[end.cell]);
  keepIfAmongTheWorst(cell, results_[end.cell].distances);
  cell.maps = {};
}

void ConsistencyBuilder::compare(const Cell& cell, CellConsistency& result) const {
  const std::vector<RevisitSegment>& segments = cell.revisit.segments;
  for (std::size_t a = 0; a < segments.size(); ++a)
    for (std::size_t b = a + 1; b < segments.size(); ++b) {
      if (!areComparable(segments[a], segments[b], config_)) continue;
      result.pairs.push_back(nearestDistances(cell.maps[a], cell.maps[b], config_.max_distance));
      result.distances += result.pairs.back();
    }
  result.thickness = planeThickness(cell.maps, config_.thickness_edge);
}

void ConsistencyBuilder::keepIfAmongTheWorst(Cell& cell, const NearestDistances& distances) {
  if (distances.paired == 0) return;
  const double rms = distances.rms();
  const auto place = std::find_if(worst_.begin(), worst_.end(),
                                  [&](const Worst& other) { return other.rms < rms; });
  worst_.insert(place, {rms, {cell.revisit, *cell.T_world_cell, std::move(cell.maps)}});
  if (worst_.size() > static_cast<std::size_t>(config_.kept_cells)) worst_.pop_back();
}

MapConsistency ConsistencyBuilder::finish() {
  closeBefore({std::numeric_limits<std::int64_t>::max()});
  std::vector<CellMaps> worst;
  for (Worst& cell : worst_) worst.push_back(std::move(cell.maps));
  return summarise(std::move(results_), std::move(worst));
}

}  // namespace revisit_slam
