// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_resampling.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "occupancy/occupancy_scenes.h"

namespace revisit_slam {
namespace {

/// Over all blocks within `half` blocks of the origin.
template <typename Visit>
void forEachBlock(int half, Visit visit) {
  for (int x = -half; x < half; ++x)
    for (int y = -half; y < half; ++y)
      for (int z = -half; z < half; ++z) visit(Voxel(x, y, z));
}

TEST(OccupancyResampling, WholeVoxelsWithoutATurnAreCopied) {
  RandomNumbers random(1);
  const SubmapOccupancyPtr submap = randomSubmap(random);
  const Voxel shift(3, -5, 8);
  const Pose T{Eigen::Quaterniond::Identity(), 0.5 * shift.cast<double>()};
  std::size_t compared = 0;
  for (const SubmapOccupancy::Entry& entry : submap->entries()) {
    const BlockCounts counts = submap->counts(entry);
    for (int bit = 0; bit < kBlockVoxels; ++bit) {
      const Voxel target = voxelAt(entry.block, bit) + shift;
      BlockEvidence evidence;
      if (bit % 37 != 0) continue;
      addEvidence(*submap, T, blockOf(target), evidence);
      EXPECT_EQ(evidence.hits[bitOf(target)], counts.hits(bit));
      EXPECT_EQ(evidence.misses[bitOf(target)], counts.misses(bit));
      ++compared;
    }
  }
  EXPECT_GT(compared, 500u);
}

TEST(OccupancyResampling, ReachesEveryBlockThatGetsEvidence) {
  RandomNumbers random(2);
  for (int trial = 0; trial < 5; ++trial) {
    const SubmapOccupancyPtr submap = randomSubmap(random);
    const Pose T = random.pose(3.0);
    const std::vector<Voxel> reached = blocksReached(*submap, T);
    forEachBlock(5, [&](const Voxel& block) {
      if (std::binary_search(reached.begin(), reached.end(), block, BlockOrder())) return;
      BlockEvidence evidence;
      addEvidence(*submap, T, block, evidence);
      EXPECT_EQ(evidence.hits, BlockEvidence().hits) << block.transpose();
      EXPECT_EQ(evidence.misses, BlockEvidence().misses) << block.transpose();
    });
  }
}

TEST(OccupancyResampling, TurningLeavesNoHoles) {
  std::vector<VoxelCounts> solid;
  for (int x = -16; x < 16; ++x)
    for (int y = -16; y < 16; ++y)
      for (int z = -16; z < 16; ++z) solid.push_back({{x, y, z}, 0, 1});
  const SubmapOccupancyPtr submap = submapOf(solid);
  RandomNumbers random(3);
  for (int trial = 0; trial < 5; ++trial) {
    const Pose T = random.pose(0.5);
    forEachBlock(1, [&](const Voxel& block) {
      BlockEvidence evidence;
      addEvidence(*submap, T, block, evidence);
      for (int bit = 0; bit < kBlockVoxels; ++bit) {
        const Eigen::Vector3d centre =
            0.5 * (voxelAt(block, bit).cast<double>().array() + 0.5).matrix();
        if (centre.norm() > 6.5) continue;
        EXPECT_EQ(evidence.misses[bit], 1u);
      }
    });
  }
}

TEST(OccupancyResampling, TurningLosesNoThinPole) {
  std::vector<VoxelCounts> pole;
  for (int z = -6; z < 6; ++z) pole.push_back({{0, 0, z}, 1, 0});
  const SubmapOccupancyPtr submap = submapOf(pole);
  RandomNumbers random(4);
  for (int trial = 0; trial < 50; ++trial) {
    const Pose T = random.pose(1.0);
    for (const VoxelCounts& v : pole) {
      const Eigen::Vector3d centre = T * Eigen::Vector3d(0.25, 0.25, 0.5 * v.voxel.z() + 0.25);
      bool found = false;  // in the voxel of its centre or one beside it
      for (int n = 0; n < 27; ++n) {
        const Voxel voxel =
            voxelOf<double>(centre / 0.5) + Voxel(n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1);
        BlockEvidence evidence;
        addEvidence(*submap, T, blockOf(voxel), evidence);
        found = found || evidence.hits[bitOf(voxel)] > 0;
      }
      EXPECT_TRUE(found);
    }
  }
}

}  // namespace
}  // namespace revisit_slam
