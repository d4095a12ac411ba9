// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/grid_points.h"

#include "revisit_slam/util/vector_clones.h"

namespace revisit_slam {

// Not in a namespace without name: the compiler makes no clones of what is only seen here.

/// Sums are added in the order in which Eigen adds those of R * p + t.
REVISIT_SLAM_VECTOR_CLONES
void moveToGrid(const float* p, std::size_t count, const Eigen::Matrix3f& R,
                const Eigen::Vector3f& t, float* __restrict x, float* __restrict y,
                float* __restrict z) {
  const float r00 = R(0, 0), r01 = R(0, 1), r02 = R(0, 2), t0 = t[0];
  const float r10 = R(1, 0), r11 = R(1, 1), r12 = R(1, 2), t1 = t[1];
  const float r20 = R(2, 0), r21 = R(2, 1), r22 = R(2, 2), t2 = t[2];
  for (std::size_t i = 0; i < count; ++i) {
    const float px = p[3 * i], py = p[3 * i + 1], pz = p[3 * i + 2];
    x[i] = (r00 * px + (r01 * py + r02 * pz)) + t0;
    y[i] = (r10 * px + (r11 * py + r12 * pz)) + t1;
    z[i] = (r20 * px + (r21 * py + r22 * pz)) + t2;
  }
}

REVISIT_SLAM_VECTOR_CLONES
void moveToGrid(const float* p, std::size_t count, const Eigen::Matrix3d& R,
                const Eigen::Vector3d& t, double* __restrict x, double* __restrict y,
                double* __restrict z) {
  const double r00 = R(0, 0), r01 = R(0, 1), r02 = R(0, 2), t0 = t[0];
  const double r10 = R(1, 0), r11 = R(1, 1), r12 = R(1, 2), t1 = t[1];
  const double r20 = R(2, 0), r21 = R(2, 1), r22 = R(2, 2), t2 = t[2];
  for (std::size_t i = 0; i < count; ++i) {
    const double px = p[3 * i], py = p[3 * i + 1], pz = p[3 * i + 2];
    x[i] = ((r00 * px + r01 * py) + r02 * pz) + t0;
    y[i] = ((r10 * px + r11 * py) + r12 * pz) + t1;
    z[i] = (r20 * px + (r21 * py + r22 * pz)) + t2;
  }
}

REVISIT_SLAM_VECTOR_CLONES
void floorScaled(const float* values, std::size_t count, float scale, int* __restrict voxels) {
  for (std::size_t i = 0; i < count; ++i) voxels[i] = floorToInt(values[i] * scale);
}

REVISIT_SLAM_VECTOR_CLONES
void floorScaled(const double* values, std::size_t count, double scale, int* __restrict voxels) {
  for (std::size_t i = 0; i < count; ++i) voxels[i] = floorToInt(values[i] * scale);
}

namespace {

template <typename Scalar>
void findVoxels(std::size_t count, Scalar scale, GridPoints<Scalar>& placed) {
  floorScaled(placed.x, count, scale, placed.voxel_x);
  floorScaled(placed.y, count, scale, placed.voxel_y);
  floorScaled(placed.z, count, scale, placed.voxel_z);
}

}  // namespace

void toGrid(const Eigen::Vector3f* points, std::size_t count, const Pose& T_grid_points,
            float scale, GridPoints<float>& placed) {
  moveToGrid(points->data(), count, T_grid_points.rotationMatrix().cast<float>(),
             T_grid_points.translation.cast<float>(), placed.x, placed.y, placed.z);
  findVoxels(count, scale, placed);
}

void toGrid(const Eigen::Vector3f* points, std::size_t count, const Pose& T_grid_points,
            double scale, GridPoints<double>& placed) {
  moveToGrid(points->data(), count, T_grid_points.rotationMatrix(), T_grid_points.translation,
             placed.x, placed.y, placed.z);
  findVoxels(count, scale, placed);
}

void toGrid(const Eigen::Vector3f* points, std::size_t count, float scale,
            GridPoints<float>& placed) {
  for (std::size_t i = 0; i < count; ++i) {
    placed.x[i] = points[i].x();
    placed.y[i] = points[i].y();
    placed.z[i] = points[i].z();
  }
  findVoxels(count, scale, placed);
}

}  // namespace revisit_slam
