// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/registration/fine_registration_surfels.h"

#include <tsl/robin_set.h>

#include <algorithm>
#include <array>
#include <utility>

namespace revisit_slam {
namespace {

using Counts = std::array<std::size_t, kDirections>;

/// Shares `count` among groups: a group that is smaller than its share leaves the rest to others.
Counts shares(const Counts& sizes, std::size_t count) {
  std::array<std::size_t, kDirections> order{0, 1, 2, 3};
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(sizes[a], a) < std::pair(sizes[b], b);
  });
  Counts taken{};
  for (std::size_t i = 0; i < kDirections; ++i) {
    taken[order[i]] = std::min(sizes[order[i]], count / (kDirections - i));
    count -= taken[order[i]];
  }
  return taken;
}

Voxel cellOf(const Eigen::Vector3f& point, float edge) {
  return voxelOf<float>(point / edge);
}

}  // namespace

std::size_t mainDirection(const Surfel& surfel) {
  if (!surfel.hasNormal()) return 3;
  Eigen::Index axis;
  surfel.normal.cwiseAbs().maxCoeff(&axis);
  return static_cast<std::size_t>(axis);
}

Surfels surfelsOf(const Submap& submap) {
  Surfels surfels(submap.points.size());
  for (std::size_t i = 0; i < surfels.size(); ++i)
    surfels[i] = {submap.points[i], submap.normals[i]};
  return surfels;
}

Surfels balanced(const Surfels& surfels, std::size_t count) {
  if (surfels.size() <= count) return surfels;
  Counts sizes{}, seen{};
  for (const Surfel& surfel : surfels) ++sizes[mainDirection(surfel)];
  const Counts taken = shares(sizes, count);
  Surfels chosen;
  chosen.reserve(count);
  for (const Surfel& surfel : surfels) {
    const std::size_t d = mainDirection(surfel), i = seen[d]++;
    const bool next_step = (i + 1) * taken[d] / sizes[d] > i * taken[d] / sizes[d];
    if (next_step) chosen.push_back(surfel);
  }
  return chosen;
}

Surfels thinned(const Surfels& surfels, double edge) {
  std::array<tsl::robin_set<std::uint64_t, VoxelKeyHash>, kDirections> seen;
  Surfels kept;
  for (const Surfel& surfel : surfels) {
    const std::uint64_t key = packVoxel(cellOf(surfel.point, static_cast<float>(edge)));
    if (seen[mainDirection(surfel)].insert(key).second) kept.push_back(surfel);
  }
  return kept;
}

SurfelGrid::SurfelGrid(const Surfels& surfels, double reach) : edge_(static_cast<float>(reach)) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(surfels.size());
  for (std::uint32_t i = 0; i < surfels.size(); ++i)
    order[i] = {packVoxel(cellOf(surfels[i].point, edge_)), i};
  std::sort(order.begin(), order.end());
  surfels_.reserve(surfels.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    surfels_.push_back(surfels[order[i].second]);
    if (i == 0 || order[i].first != order[i - 1].first) {
      cell_of_.tryEmplace(cellOf(surfels_[i].point, edge_),
                          static_cast<std::uint32_t>(cells_.size()));
      cells_.push_back({i, i});
    }
    cells_.back().end = i + 1;
  }
}

const Surfel* SurfelGrid::nearest(const Eigen::Vector3f& point, const Eigen::Vector3f& normal,
                                  float distance, const Surfel* guess) const {
  const Eigen::Array3f reach = Eigen::Array3f::Constant(distance);
  const Voxel first = cellOf(point.array() - reach, edge_);
  const Voxel last = cellOf(point.array() + reach, edge_);
  float best = distance * distance;
  const Surfel* found = nullptr;
  const auto offer = [&](const Surfel& surfel) {
    const float squared = (surfel.point - point).squaredNorm();
    if (squared >= best || !compatible(surfel.normal, normal)) return;
    best = squared;
    found = &surfel;
  };
  VoxelNumbers::Reader cell_of(cell_of_);
  const auto look = [&](const Voxel& voxel) {
    const Eigen::Array3f low = edge_ * voxel.cast<float>().array() - point.array();
    const float gap = low.max(-low - edge_).max(0.0f).matrix().squaredNorm();
    if (gap >= best) return;
    const std::uint32_t cell = cell_of.at(voxel);
    if (cell == VoxelNumbers::kNone) return;
    for (std::uint32_t i = cells_[cell].begin; i < cells_[cell].end; ++i) offer(surfels_[i]);
  };
  if (guess) offer(*guess);
  const Voxel home = cellOf(point, edge_);
  look(home);
  for (int x = first.x(); x <= last.x(); ++x)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int z = first.z(); z <= last.z(); ++z)
        if (const Voxel voxel(x, y, z); voxel != home) look(voxel);
  return found;
}

}  // namespace revisit_slam
