// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/local_voxel_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kBlocksAtATime = 128;
/// The vertical part of the normal of a level plane is at least this.
constexpr float kLevel = 0.9f;

/// The 26 neighbours of a voxel: those that share a face first, then an edge, then a corner.
std::array<Voxel, 26> makeNeighbourOffsets() {
  std::array<Voxel, 26> offsets;
  std::size_t count = 0;
  for (int shared : {1, 2, 3})
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (std::abs(x) + std::abs(y) + std::abs(z) == shared) offsets[count++] = Voxel(x, y, z);
  return offsets;
}

const std::array<Voxel, 26> kNeighbourOffsets = makeNeighbourOffsets();

/// The best two of a stream of squared distances.
struct BestTwo {
  float best;
  float second = std::numeric_limits<float>::max();
  std::uint32_t block = 0;
  std::size_t point = 0;
  bool found = false;

  void offer(float squared, std::uint32_t in_block, std::size_t index) {
    if (squared < best) {
      second = found ? best : second;
      best = squared;
      block = in_block;
      point = index;
      found = true;
    } else if (squared < second) {
      second = squared;
    }
  }
};

}  // namespace

LocalVoxelMap::LocalVoxelMap(const LocalVoxelMapConfig& config, bool local_shapes)
    : voxel_size_(config.voxel_size),
      has_shapes_(local_shapes),
      max_points_(static_cast<std::size_t>(config.max_points_per_voxel)),
      quads_per_block_((max_points_ + kLanes - 1) / kLanes),
      min_spacing_squared_(
          static_cast<float>(voxel_size_ * voxel_size_ / config.max_points_per_voxel)),
      farther_(kFartherEdges * config.voxel_size) {}

Points LocalVoxelMap::points(const Pose& T_target_odom) const {
  Points points;
  for (BlockIndex block = 0; block < sizes_.size(); ++block) {
    for (std::size_t i = 0; i < sizes_[block]; ++i) {
      const Eigen::Vector3f in_voxel = inVoxel(block, i);
      points.push_back((T_target_odom * (corner(block) + in_voxel.cast<double>())).cast<float>());
    }
  }
  return points;
}

void LocalVoxelMap::insert(const Points& points_base, const Pose& T_odom_base) {
  const Eigen::Matrix3d R = T_odom_base.rotationMatrix();
  Voxel previous_voxel = Voxel::Constant(std::numeric_limits<int>::max());
  BlockIndex block = 0;
  std::vector<BlockIndex> changed;
  for (const Eigen::Vector3f& point_base : points_base) {
    const Eigen::Vector3d point = R * point_base.cast<double>() + T_odom_base.translation;
    const Voxel voxel = voxelOf<double>(point / voxel_size_);
    if (voxel != previous_voxel) block = findOrCreateBlock(voxel);
    previous_voxel = voxel;
    const Eigen::Vector3f in_voxel = (point - corner(block)).cast<float>();
    if (!insertIntoBlock(block, in_voxel) || !has_shapes_) continue;
    moments_[block].add(in_voxel);
    farther_.add(point);
    changed.push_back(block);
  }
  updateShapes(changed);
}

void LocalVoxelMap::updateShapes(std::vector<BlockIndex>& changed) {
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  Chunks(changed.size(), kBlocksAtATime).forEach([&](std::size_t, Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      shapes_[changed[i]] = shapeAt(voxels_[changed[i]]);
  });
}

LocalShape LocalVoxelMap::shapeAt(const Voxel& voxel) const {
  const auto edge = static_cast<float>(voxel_size_);
  const PointMoments near = momentsAround(voxel);
  LocalShape shape = localShapeOf(near, edge);
  if (!shape.is_line) return shape;
  return widenedShapeOf(shape, near, farther_.around(voxel_size_ * voxel.cast<double>()), edge);
}

PointMoments LocalVoxelMap::momentsAround(const Voxel& voxel) const {
  PointMoments around;
  VoxelNumbers::Reader block_of(block_of_);
  const auto add = [&](const Voxel& offset) {
    const BlockIndex block = block_of.at(voxel + offset);
    if (block == VoxelNumbers::kNone) return;
    const Eigen::Vector3f shift = static_cast<float>(voxel_size_) * offset.cast<float>();
    around.add(moments_[block], shift);
  };
  add(Voxel::Zero());
  for (const Voxel& offset : kNeighbourOffsets) add(offset);
  return around;
}

bool LocalVoxelMap::isLevel(BlockIndex block) const {
  if (block == VoxelNumbers::kNone) return false;
  const LocalShape& shape = shapes_[block];
  return shape.kind == ShapeKind::planar && std::abs(shape.normal.z()) > kLevel;
}

double LocalVoxelMap::coveredShare(int lowest, int highest) const {
  std::size_t level = 0, covered = 0;
  VoxelNumbers::Reader block_of(block_of_);
  for (BlockIndex block = 0; block < shapes_.size(); ++block) {
    if (sizes_[block] == 0 || !isLevel(block)) continue;
    ++level;
    const auto is_level_above = [&](int voxels) {
      return isLevel(block_of.at(voxels_[block] + voxels * Voxel::UnitZ()));
    };
    if (is_level_above(1)) continue;  // the same plane
    for (int k = lowest; k <= highest; ++k) {
      if (!is_level_above(k)) continue;
      ++covered;
      break;
    }
  }
  return level == 0 ? 0.0 : static_cast<double>(covered) / static_cast<double>(level);
}

LocalVoxelMap::BlockIndex LocalVoxelMap::findOrCreateBlock(const Voxel& voxel) {
  if (free_blocks_.empty()) addFreeBlock();
  const BlockIndex next = free_blocks_.back();
  const BlockIndex block = block_of_.tryEmplace(voxel, next);
  if (block != next) return block;
  free_blocks_.pop_back();
  std::fill_n(quads_.begin() + static_cast<std::ptrdiff_t>(block * quads_per_block_),
              quads_per_block_, Quad::empty());
  voxels_[block] = voxel;
  if (has_shapes_) {
    moments_[block] = {};
    shapes_[block] = {};
  }
  return block;
}

/// Before a voxel has its number: where memory is short the map is as it was.
void LocalVoxelMap::addFreeBlock() {
  const std::size_t blocks = sizes_.size() + 1;
  quads_.resize(blocks * quads_per_block_);
  voxels_.resize(blocks);
  moments_.resize(has_shapes_ ? blocks : 0);
  shapes_.resize(moments_.size());
  sizes_.push_back(0);
  free_blocks_.push_back(static_cast<BlockIndex>(blocks - 1));
}

bool LocalVoxelMap::insertIntoBlock(BlockIndex block, const Eigen::Vector3f& point_voxel) {
  const std::size_t size = sizes_[block];
  if (size == max_points_) return false;
  Quad* const quads = &quads_[block * quads_per_block_];
  for (std::size_t q = 0; q < quadsOf(block); ++q) {
    float squared[kLanes];
    quads[q].squaredDistances(point_voxel, squared);
    for (const float each : squared)
      if (each < min_spacing_squared_) return false;
  }
  Quad& quad = quads[size / kLanes];
  quad.x[size % kLanes] = point_voxel.x();
  quad.y[size % kLanes] = point_voxel.y();
  quad.z[size % kLanes] = point_voxel.z();
  ++sizes_[block];
  return true;
}

void LocalVoxelMap::dropBeyond(const Eigen::Vector3d& centre_odom, double distance) {
  farther_.dropBeyond(centre_odom, distance + kFartherEdges * voxel_size_);
  const Eigen::Vector3f centre =
      (centre_odom / voxel_size_ - Eigen::Vector3d::Constant(0.5)).cast<float>();
  const float limit = static_cast<float>(distance * distance / (voxel_size_ * voxel_size_));
  for (BlockIndex block = 0; block < sizes_.size(); ++block) {
    if (sizes_[block] == 0) continue;
    if ((voxels_[block].cast<float>() - centre).squaredNorm() <= limit) continue;
    free_blocks_.push_back(block);
    sizes_[block] = 0;
    block_of_.erase(voxels_[block]);
  }
}

bool LocalVoxelMap::nearest(const Eigen::Vector3d& query_odom, double max_distance,
                            Neighbour& neighbour) const {
  const Voxel voxel = voxelOf<double>(query_odom / voxel_size_);
  const Eigen::Vector3f query = (query_odom - voxel_size_ * voxel.cast<double>()).cast<float>();
  const float edge = static_cast<float>(voxel_size_);
  BestTwo best{static_cast<float>(max_distance * max_distance)};
  // Points outside the 27 voxels, and in voxels that are not looked into, are at least this far.
  float unseen = edge * edge;

  VoxelNumbers::Reader block_of(block_of_);
  const auto look = [&](const Voxel& offset) {
    const BlockIndex block = block_of.at(voxel + offset);
    if (block == VoxelNumbers::kNone) return;
    const Eigen::Vector3f query_block = query - edge * offset.cast<float>();
    const Quad* const first = quads(block);
    const std::size_t count = quadsOf(block);
    for (std::size_t q = 0; q < count; ++q) {
      float squared[kLanes];
      first[q].squaredDistances(query_block, squared);
      const float least =
          std::min(std::min(squared[0], squared[1]), std::min(squared[2], squared[3]));
      if (least >= best.second) continue;
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        best.offer(squared[lane], block, q * kLanes + lane);
    }
  };

  look(Voxel::Zero());
  // Squared distance from the query to its voxel's lower face, to itself, to the upper face.
  const Eigen::Vector3f lower = query.cwiseAbs2();
  const Eigen::Vector3f upper = (Eigen::Vector3f::Constant(edge) - query).cwiseAbs2();
  const float nearest_face = std::min(lower.minCoeff(), upper.minCoeff());
  if (best.found && best.best <= nearest_face) {
    unseen = nearest_face;
  } else {
    for (const Voxel& offset : kNeighbourOffsets) {
      float gap = 0.0f;
      for (int axis = 0; axis < 3; ++axis)
        gap += offset[axis] == 0 ? 0.0f : offset[axis] < 0 ? lower[axis] : upper[axis];
      if (gap < best.best) {
        look(offset);
      } else {
        unseen = std::min(unseen, gap);
      }
    }
  }
  if (!best.found) return false;

  neighbour.point_odom = corner(best.block) + inVoxel(best.block, best.point).cast<double>();
  neighbour.shape = has_shapes_ ? shapes_[best.block] : LocalShape{};
  neighbour.distance = std::sqrt(best.best);
  neighbour.rival_distance = std::sqrt(std::min(best.second, unseen));
  return true;
}

}  // namespace revisit_slam
