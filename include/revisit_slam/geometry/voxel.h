// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace revisit_slam {

/// Integer coordinates of a cubic voxel: the point p lies in floor(p / edge), per axis.
using Voxel = Eigen::Vector3i;

/// floor for values that fit an int. std::floor is a library call where SSE4.1 may not be assumed.
template <typename Scalar>
inline int floorToInt(Scalar value) {
  const int truncated = static_cast<int>(value);
  return truncated - (value < static_cast<Scalar>(truncated) ? 1 : 0);
}

/// Voxel of a point whose coordinates are already divided by the voxel's edge.
template <typename Scalar>
inline Voxel voxelOf(const Eigen::Matrix<Scalar, 3, 1>& scaled_point) {
  return {floorToInt(scaled_point.x()), floorToInt(scaled_point.y()), floorToInt(scaled_point.z())};
}

constexpr int kVoxelBits = 21;  // of each axis in a packed voxel
/// Coordinates that a packed voxel can tell apart: [-limit, limit).
constexpr int kVoxelLimit = 1 << (kVoxelBits - 1);

/// The voxel in one integer; unique for coordinates within kVoxelLimit.
inline std::uint64_t packVoxel(const Voxel& voxel) {
  constexpr std::uint64_t mask = (std::uint64_t{1} << kVoxelBits) - 1;
  const auto part = [](int c) { return static_cast<std::uint64_t>(c + kVoxelLimit) & mask; };
  return part(voxel.x()) << (2 * kVoxelBits) | part(voxel.y()) << kVoxelBits | part(voxel.z());
}

/// Spreads a packed voxel over 64 bits; the high bits are the well-mixed ones.
inline std::uint64_t mixVoxelKey(std::uint64_t key) {
  key ^= key >> 32;
  key *= 0x9E3779B97F4A7C15ull;  // 2^64 / golden ratio (Fibonacci hashing)
  return key ^ (key >> 29);
}

struct VoxelKeyHash {
  std::size_t operator()(std::uint64_t key) const { return mixVoxelKey(key); }
};

}  // namespace revisit_slam
