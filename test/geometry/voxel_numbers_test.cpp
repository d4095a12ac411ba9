// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/voxel_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

using Reference = std::map<std::array<int, 3>, std::uint32_t>;

std::array<int, 3> nameOf(const Voxel& voxel) {
  return {voxel.x(), voxel.y(), voxel.z()};
}

/// Every voxel of a box around the origin, and what is visited, against the reference.
void expectSame(const VoxelNumbers& numbers, const Reference& reference, int half) {
  EXPECT_EQ(numbers.size(), reference.size());
  EXPECT_EQ(numbers.empty(), reference.empty());
  VoxelNumbers::Reader reader(numbers);
  for (int x = -half; x < half; ++x)
    for (int y = -half; y < half; ++y)
      for (int z = -half; z < half; ++z) {
        const auto entry = reference.find({x, y, z});
        ASSERT_EQ(reader.at({x, y, z}),
                  entry == reference.end() ? VoxelNumbers::kNone : entry->second)
            << x << " " << y << " " << z;
      }
  auto expected = reference.begin();  // in the same order
  numbers.forEach([&](const Voxel& voxel, std::uint32_t number) {
    ASSERT_NE(expected, reference.end());
    EXPECT_EQ(nameOf(voxel), expected->first);
    EXPECT_EQ(number, expected->second);
    ++expected;
  });
  EXPECT_EQ(expected, reference.end());
}

TEST(VoxelNumbers, FollowWhatEntersAndWhatIsErased) {
  constexpr int half = 9;
  RandomNumbers random(2);
  VoxelNumbers numbers;
  Reference reference;
  expectSame(numbers, reference, half);
  for (std::uint32_t next = 0; next < 4000; ++next) {
    const Voxel voxel = voxelOf<double>(random.inCube(half));
    const bool leaves = next % 1000 >= 500;  // more is erased than enters: cubes get empty
    const auto entry = reference.find(nameOf(voxel));
    if (entry == reference.end()) {
      if (leaves && next % 8 != 0) continue;
      EXPECT_EQ(numbers.tryEmplace(voxel, next), next);
      reference.emplace(nameOf(voxel), next);
    } else if (leaves) {
      numbers.erase(voxel);
      reference.erase(entry);
    } else {
      EXPECT_EQ(numbers.tryEmplace(voxel, next), entry->second);
    }
    if (next % 400 == 0) expectSame(numbers, reference, half);
  }
  expectSame(numbers, reference, half);
  while (!reference.empty()) {
    const std::array<int, 3> name = reference.begin()->first;
    numbers.erase({name[0], name[1], name[2]});
    reference.erase(reference.begin());
  }
  expectSame(numbers, reference, half);
}

TEST(VoxelNumbers, ReadersSeeAcrossCubes) {
  VoxelNumbers numbers;
  numbers.tryEmplace({-1, 0, 3}, 7);
  numbers.tryEmplace({0, 0, 3}, 8);
  numbers.tryEmplace({1'000'000, -1'000'000, 4}, 9);
  VoxelNumbers::Reader reader(numbers);
  EXPECT_EQ(reader.at({-1, 0, 3}), 7u);
  EXPECT_EQ(reader.at({0, 0, 3}), 8u);
  EXPECT_EQ(reader.at({0, 0, 4}), VoxelNumbers::kNone);
  EXPECT_EQ(reader.at({1'000'000, -1'000'000, 4}), 9u);
  EXPECT_EQ(reader.at({-1, 0, 3}), 7u);
}

}  // namespace
}  // namespace revisit_slam
