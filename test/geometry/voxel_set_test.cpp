// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/voxel_set.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

TEST(VoxelSet, TellsWhichVoxelsAreNew) {
  RandomNumbers random(1);
  VoxelSet set;
  for (const double half : {3.0, 40.0, 5000.0}) {  // dense, as on surfaces, and one a block
    set.clear();
    std::set<std::array<int, 3>> seen;
    std::size_t repeated = 0;
    for (int i = 0; i < 5000; ++i) {
      const Voxel voxel = voxelOf<double>(random.inCube(half));
      const bool is_new = seen.insert({voxel.x(), voxel.y(), voxel.z()}).second;
      ASSERT_EQ(set.insert(voxel), is_new) << voxel.transpose();
      repeated += !is_new;
    }
    EXPECT_EQ(repeated > 0, half < 1000.0);
  }
}

TEST(VoxelSet, TellsFarVoxelsApart) {
  VoxelSet set;
  constexpr int far = 8'000'000;
  for (const Voxel& voxel : {Voxel(far, 0, 0), Voxel(-far, 0, 0), Voxel(0, 0, -far),
                             Voxel(0, far, 0), Voxel(far - 1, 0, 0), Voxel(0, 0, 0)})
    EXPECT_TRUE(set.insert(voxel)) << voxel.transpose();
  EXPECT_FALSE(set.insert(Voxel(-far, 0, 0)));
}

}  // namespace
}  // namespace revisit_slam
