// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "revisit_slam/geometry/voxel_numbers.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// A point of a surface; the normal is zero where there is none.
struct Surfel {
  Eigen::Vector3f point;
  Eigen::Vector3f normal;

  bool hasNormal() const { return normal.squaredNorm() > 0.5f; }
};

using Surfels = std::vector<Surfel>;

/// A transform in the precision of surfels.
struct SurfelPose {
  explicit SurfelPose(const Pose& T)
      : R(T.rotationMatrix().cast<float>()), t(T.translation.cast<float>()) {}

  Surfel operator*(const Surfel& a) const { return {R * a.point + t, R * a.normal}; }

  Eigen::Matrix3f R;
  Eigen::Vector3f t;
};

/// Whether two normals may belong to one side of a surface: within 45 degrees. A point without
/// normal fits any.
inline bool compatible(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return a.dot(b) > 0.7071f || a.isZero() || b.isZero();
}

/// The axis of the submap that the normal is nearest to, 0 to 2; 3 without normal.
constexpr std::size_t kDirections = 4;
std::size_t mainDirection(const Surfel& surfel);

Surfels surfelsOf(const Submap& submap);

/// At most `count` surfels, as many as possible of each main direction of normals (and of those
/// without), so that the ground does not outnumber what holds the pose in the plane. Evenly spread
/// over the order of the input.
Surfels balanced(const Surfels& surfels, std::size_t count);

/// The first surfel of each main direction in each cube of edge `edge`, metres.
Surfels thinned(const Surfels& surfels, double edge);

/// Surfels in the cells of a hash grid, for searches within the edge of a cell.
class SurfelGrid {
 public:
  /// `reach` in metres: the edge of a cell.
  SurfelGrid(const Surfels& surfels, double reach);

  /// The nearest compatible surfel within `distance` <= reach, or null. `guess`: one of this grid
  /// that may be near, which saves looking farther.
  const Surfel* nearest(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, float distance,
                        const Surfel* guess = nullptr) const;

 private:
  struct Cell {
    std::uint32_t begin, end;
  };

  float edge_;
  Surfels surfels_;  // by cell
  VoxelNumbers cell_of_;
  std::vector<Cell> cells_;
};

}  // namespace revisit_slam
