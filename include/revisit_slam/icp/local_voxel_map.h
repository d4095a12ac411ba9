// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "revisit_slam/geometry/voxel_numbers.h"
#include "revisit_slam/icp/local_shape.h"
#include "revisit_slam/icp/local_voxel_map_config.h"
#include "revisit_slam/icp/moment_grid.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// The map point nearest to a query, the shape of the map around it, and how far its rivals are.
struct Neighbour {
  Eigen::Vector3d point_odom;
  LocalShape shape;
  float distance;        ///< m, from the query to the point
  float rival_distance;  ///< m, lower bound of the distance from the query to any other point
};

/// The points around the robot that scans are registered to, in cubic voxels (KISS-ICP Sec. III-C).
/// A point enters when its voxel has room and no point of that voxel is closer than
/// voxel_size / sqrt(max_points_per_voxel). The local shape of a voxel is determined anew
/// whenever a point enters it; where its points are along a line, what lies farther around counts,
/// too. Points are kept relative to their voxel, so that float holds them to a micrometre anywhere
/// on Earth. What the map holds depends on the order of the calls alone.
class LocalVoxelMap {
 public:
  /// `local_shapes`: false leaves out the shapes of neighbours, which are then sparse without
  /// points.
  explicit LocalVoxelMap(const LocalVoxelMapConfig& config, bool local_shapes = true);

  bool empty() const { return block_of_.empty(); }
  std::size_t voxels() const { return block_of_.size(); }
  double voxelSize() const { return voxel_size_; }
  /// m, the smallest distance between two points of a voxel.
  double pointSpacing() const { return std::sqrt(static_cast<double>(min_spacing_squared_)); }
  Points points(const Pose& T_target_odom = {}) const;

  /// Runs in the current TBB arena; the same bits for any number of threads.
  void insert(const Points& points_base, const Pose& T_odom_base);

  /// Drops every voxel whose centre is farther than `distance` from `centre_odom`.
  void dropBeyond(const Eigen::Vector3d& centre_odom, double distance);

  /// The nearest point within the 27 voxels around the query, if it is nearer than `max_distance`.
  /// Exact; looks only into voxels that can hold a nearer point than the best so far.
  bool nearest(const Eigen::Vector3d& query_odom, double max_distance, Neighbour& neighbour) const;

  /// Of the voxels with a level plane: the share that has another such voxel above it, `lowest` (at
  /// least two) to `highest` voxels up, and none that touches it. Floors under ceilings.
  double coveredShare(int lowest, int highest) const;

  /// Calls see(point_odom - query_odom, its squared length) for every point within `radius` of the
  /// query, in an order that depends on the voxels alone. The radius is taken a little larger.
  template <typename See>
  void forEachAround(const Eigen::Vector3d& query_odom, double radius, const See& see) const;

 private:
  using BlockIndex = std::uint32_t;

  static constexpr std::size_t kLanes = 4;
  /// As many points as a vector register takes, from their voxel's corner, metres. Where there is
  /// no point, one that is farther than any.
  struct alignas(16) Quad {
    float x[kLanes], y[kLanes], z[kLanes];

    static constexpr float kNowhere = 1e18f;  // its square is still a float
    static Quad empty() {
      Quad quad;
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        quad.x[lane] = quad.y[lane] = quad.z[lane] = kNowhere;
      return quad;
    }
    Eigen::Vector3f at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
    /// Squared distances to a query that is given as the points are.
    void squaredDistances(const Eigen::Vector3f& query, float (&squared)[kLanes]) const {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const float dx = x[lane] - query.x(), dy = y[lane] - query.y(), dz = z[lane] - query.z();
        squared[lane] = dx * dx + dy * dy + dz * dz;
      }
    }
  };

  BlockIndex findOrCreateBlock(const Voxel& voxel);
  void addFreeBlock();
  /// @return whether the point entered.
  bool insertIntoBlock(BlockIndex block, const Eigen::Vector3f& point_voxel);
  void updateShapes(std::vector<BlockIndex>& changed);
  bool isLevel(BlockIndex block) const;
  PointMoments momentsAround(const Voxel& voxel) const;
  LocalShape shapeAt(const Voxel& voxel) const;
  const Quad* quads(BlockIndex block) const { return &quads_[block * quads_per_block_]; }
  std::size_t quadsOf(BlockIndex block) const { return (sizes_[block] + kLanes - 1) / kLanes; }
  Eigen::Vector3f inVoxel(BlockIndex block, std::size_t point) const {
    return quads(block)[point / kLanes].at(point % kLanes);
  }
  Eigen::Vector3d corner(BlockIndex block) const {
    return voxel_size_ * voxels_[block].cast<double>();
  }

  double voxel_size_;
  bool has_shapes_;
  std::size_t max_points_;
  std::size_t quads_per_block_;
  float min_spacing_squared_;

  VoxelNumbers block_of_;
  MomentGrid farther_;  // its points may be gone from the map; empty without shapes
  std::vector<Quad> quads_;
  std::vector<Voxel> voxels_;
  std::vector<PointMoments> moments_;  // from the voxel's corner; empty without shapes
  std::vector<LocalShape> shapes_;     // empty without shapes
  std::vector<std::uint16_t> sizes_;   // 0: the block is free
  std::vector<BlockIndex> free_blocks_;
};

template <typename See>
void LocalVoxelMap::forEachAround(const Eigen::Vector3d& query_odom, double radius,
                                  const See& see) const {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius);
  const Voxel home = voxelOf<double>(query_odom / voxel_size_);
  const Voxel first = voxelOf<double>((query_odom - reach) / voxel_size_) - home;
  const Voxel last = voxelOf<double>((query_odom + reach) / voxel_size_) - home;
  const Eigen::Vector3f query = (query_odom - voxel_size_ * home.cast<double>()).cast<float>();
  const float edge = static_cast<float>(voxel_size_);
  const float limit = static_cast<float>(radius * radius * (1.0 + 1e-5));
  VoxelNumbers::Reader block_of(block_of_);
  for (int x = first.x(); x <= last.x(); ++x)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int z = first.z(); z <= last.z(); ++z) {
        const Voxel offset(x, y, z);
        const Eigen::Vector3f corner = edge * offset.cast<float>() - query;
        const Eigen::Vector3f outside =
            corner.cwiseMax(-corner - Eigen::Vector3f::Constant(edge)).cwiseMax(0.0f);
        if (outside.squaredNorm() > limit) continue;
        const BlockIndex block = block_of.at(home + offset);
        if (block == VoxelNumbers::kNone) continue;
        for (const Quad *quad = quads(block), *end = quad + quadsOf(block); quad != end; ++quad) {
          Quad relative;
          float squared[kLanes];
          for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const float px = relative.x[lane] = quad->x[lane] + corner.x();
            const float py = relative.y[lane] = quad->y[lane] + corner.y();
            const float pz = relative.z[lane] = quad->z[lane] + corner.z();
            squared[lane] = px * px + (py * py + pz * pz);
          }
          for (std::size_t lane = 0; lane < kLanes; ++lane)
            if (squared[lane] <= limit) see(relative.at(lane), squared[lane]);
        }
      }
}

}  // namespace revisit_slam
