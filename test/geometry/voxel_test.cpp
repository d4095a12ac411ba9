// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/voxel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

TEST(Voxel, FloorsNegativeCoordinates) {
  const auto check = [](auto value) { EXPECT_EQ(floorToInt(value), std::floor(value)) << value; };
  for (const double value : {0.0, -0.0, 0.5, -0.5, 1.0, -1.0, -1e-300, 2.999, -2.001, 1e9, -1e9,
                             std::nextafter(1.0, 0.0), std::nextafter(-1.0, -2.0)}) {
    check(value);
    check(static_cast<float>(value));
  }
  EXPECT_EQ(voxelOf<float>({-0.1f, 0.1f, -1.0f}), Voxel(-1, 0, -1));
  EXPECT_EQ(voxelOf<double>({-3.5, 2.0, 1.99}), Voxel(-4, 2, 1));
}

TEST(Voxel, KeysAreUniqueUpToTheLimits) {
  constexpr int limit = kVoxelLimit;
  const int ends[] = {-limit, -limit + 1, -1, 0, 1, limit - 2, limit - 1};
  std::set<std::uint64_t> keys;
  for (int x : ends)
    for (int y : ends)
      for (int z : ends) {
        const std::uint64_t key = packVoxel({x, y, z});
        EXPECT_LE(key, std::numeric_limits<std::uint64_t>::max() >> (64 - 3 * kVoxelBits));
        keys.insert(key);
      }
  EXPECT_EQ(keys.size(), 7u * 7u * 7u);
}

TEST(Voxel, KeysOfADenseBlockAreUnique) {
  std::set<std::uint64_t> keys;
  for (int x = -10; x < 10; ++x)
    for (int y = -10; y < 10; ++y)
      for (int z = -10; z < 10; ++z) keys.insert(packVoxel({x, y, z}));
  EXPECT_EQ(keys.size(), 8000u);
}

/// A wall fills few values of one coordinate: its hashes must spread all the same.
TEST(Voxel, HashSpreadsPlanesOverTheBuckets) {
  constexpr std::size_t buckets = 4096;
  for (int axis = 0; axis < 3; ++axis) {
    std::set<std::size_t> low_bits;
    for (int u = 0; u < 64; ++u)
      for (int v = 0; v < 64; ++v) {
        Voxel voxel(u - 32, u - 32, u - 32);
        voxel[axis] = 5;
        voxel[(axis + 1) % 3] = v - 32;
        low_bits.insert(VoxelKeyHash()(packVoxel(voxel)) % buckets);
      }
    EXPECT_GT(low_bits.size(), buckets / 2) << axis;  // random hashes fill 63 per cent
  }
}

}  // namespace
}  // namespace revisit_slam
