// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/normals.h"

#include <algorithm>
#include <array>

#include "revisit_slam/geometry/point_moments.h"
#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kChunkLength = 4096;
constexpr float kFewestPoints = 5.0f;
/// Standard deviations along the principal axes, smallest s0 to largest s2: a plane has s0 below
/// this share of s1, and is not a line, where s1 is below the other share of s2.
constexpr float kThickest = 0.35f;
constexpr float kNarrowest = 0.25f;

/// Steps of a packed key from a voxel to its neighbours along x, y and z.
const std::uint64_t kStepX = packVoxel(Voxel(1, 0, 0)) - packVoxel(Voxel(0, 0, 0));
const std::uint64_t kStepY = packVoxel(Voxel(0, 1, 0)) - packVoxel(Voxel(0, 0, 0));

Eigen::Vector3f normalOf(const PointMoments& moments) {
  if (moments.count < kFewestPoints) return Eigen::Vector3f::Zero();
  const PrincipalAxes principal = moments.principalAxes();
  const Eigen::Vector3f s = principal.variances.cwiseSqrt();
  const bool planar = s[0] <= kThickest * s[1] && s[1] >= kNarrowest * s[2] && s[1] > 0.0f;
  return planar ? Eigen::Vector3f(principal.axes.col(0)) : Eigen::Vector3f::Zero();
}

/// Goes through the ordered voxels and keeps nine places in the list along with it, one for each
/// column of voxels around: all of them only move forward, so that no neighbour is searched for.
class Neighbourhood {
 public:
  Neighbourhood(const VoxelMeans& means, std::size_t first) : means_(means) {
    const auto begin = means.keys.begin();
    for (std::size_t column = 0; column < cursors_.size(); ++column)
      cursors_[column] = static_cast<std::size_t>(
          std::lower_bound(begin, means.keys.end(), lowest(column, first)) - begin);
  }

  /// The points around voxel `index`, relative to its own; indices must ascend.
  PointMoments moments(std::size_t index) {
    PointMoments moments;
    for (std::size_t column = 0; column < cursors_.size(); ++column) {
      const std::uint64_t low = lowest(column, index);
      std::size_t& cursor = cursors_[column];
      while (cursor < means_.keys.size() && means_.keys[cursor] < low) ++cursor;
      for (std::size_t i = cursor; i < means_.keys.size() && means_.keys[i] <= low + 2; ++i)
        moments.add(means_.points[i] - means_.points[index]);
    }
    return moments;
  }

 private:
  /// Key of the lowest voxel of a column around voxel `index`.
  std::uint64_t lowest(std::size_t column, std::size_t index) const {
    return means_.keys[index] - kStepX - kStepY - 1 + column / 3 * kStepX + column % 3 * kStepY;
  }

  const VoxelMeans& means_;
  std::array<std::size_t, 9> cursors_;
};

}  // namespace

Points estimateNormals(const VoxelMeans& means) {
  Points normals(means.points.size());
  Chunks(normals.size(), kChunkLength).forEach([&](std::size_t, Chunk chunk) {
    Neighbourhood around(means, chunk.begin);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Eigen::Vector3f normal = normalOf(around.moments(i));
      normals[i] = normal.dot(means.points[i]) > 0.0f ? Eigen::Vector3f(-normal) : normal;
    }
  });
  return normals;
}

}  // namespace revisit_slam
